// SPDX-License-Identifier: MIT
// HTML and texts from files, as pages show them.
#pragma once

#include "markup/html_text.hpp"

namespace regista::report {

using markup::data_address;
using markup::Html;
using markup::lines;
using markup::Markup;
using markup::name;
using markup::path_address;
using markup::text;
using markup::operator""_html;

}  // namespace regista::report
