#pragma once
#include "document.hpp"
#include "towform/case.hpp"

namespace towform {

/// Reads every key of the document, and of the card it names, into the case, whose path is set; finds the
/// meshes. Each key by itself: what keys say together is for check_case().
void read_keys_of(const Value& document, Case& c, std::vector<InputIssue>& issues);

/// The keys of [material] and blank.thickness alone; every other key may be missing, none may be unknown.
void read_material_keys_of(const Value& document, Case& c, std::vector<InputIssue>& issues);

} // namespace towform
