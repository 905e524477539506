#pragma once
#include "material/fabric_law.hpp"

namespace towform {

/// A material whose law the program brought (`material.own_law`). Its surface is what the law answers when it
/// is driven from rest at a constant rate, as in a picture frame; its curves are straight lines as steep as
/// the law's modulus at the rates that the indicator counts by, so that whoever bounds the shear stiffness by
/// curves finds it. Throws std::domain_error: no law was brought, a modulus or forces that are no good.
FabricMaterial own_material(const MaterialParameters& material);

} // namespace towform
