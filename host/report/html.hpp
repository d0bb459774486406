// SPDX-License-Identifier: MIT
// HTML and texts from files, as pages show them.
#pragma once

#include "text/html.hpp"

namespace regista::report {

using text::data_address;
using text::Html;
using text::lines;
using text::Markup;
using text::name;
using text::path_address;
using text::text;
using text::operator""_html;

}  // namespace regista::report
