#include "solver/statics_increments.hpp"
#include <gtest/gtest.h>
