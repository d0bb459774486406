// SPDX-License-Identifier: MIT
// HTML and texts from files, as pages show them.
#pragma once

#include "texts/html.hpp"

namespace regista::report {

using texts::data_address;
using texts::Html;
using texts::lines;
using texts::Markup;
using texts::path_address;
using texts::text;
using texts::operator""_html;

}  // namespace regista::report
