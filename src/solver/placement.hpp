#pragma once
#include "contact/tool.hpp"
#include "towform/blank.hpp"
#include "towform/case.hpp"
#include <vector>

namespace towform {

/// Where the tools stand against the flat blank at the start: adds an issue for every tool whose size says
/// that its unit is wrong, that holds part of the blank inside it, or that can never meet the blank.
void check_placement(const Case& c, const Blank& blank, const std::vector<Tool>& tools,
                     std::vector<InputIssue>& issues);

} // namespace towform
