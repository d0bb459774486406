// SPDX-License-Identifier: MIT
// abi.h is C++20 too, with the same layout, and its structs are plain data.
#include <type_traits>

#include "layout.h"

static_assert(std::is_standard_layout_v<regista_frame> && std::is_trivial_v<regista_frame>);
static_assert(std::is_standard_layout_v<regista_world> && std::is_trivial_v<regista_world>);
static_assert(std::is_standard_layout_v<regista_body> && std::is_trivial_v<regista_body>);
static_assert(std::is_standard_layout_v<regista_action> && std::is_trivial_v<regista_action>);
static_assert(std::is_standard_layout_v<regista_environment> && std::is_trivial_v<regista_environment>);
static_assert(std::is_standard_layout_v<regista_descriptor> && std::is_trivial_v<regista_descriptor>);
static_assert(
    std::is_same_v<decltype(&regista_plugin_entry), const regista_descriptor* (*)(uint32_t, uint32_t, uint32_t)>);
