#pragma once
#include <string_view>

namespace towform::resources {

/// The page's style sheet.
std::string_view style();
/// The bundled 3-D view; empty when this towform was built without Node.
std::string_view viewer();

} // namespace towform::resources
