# SPDX-License-Identifier: MIT
# Writes <folder>/changelog.gz in Debian's form for version <version> of <package>. Its only entry points to CHANGELOG.md.
string(TIMESTAMP time "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(CONFIGURE OUTPUT ${folder}/changelog @ONLY CONTENT
[[@package@ (@version@) bookworm; urgency=medium

  * What users notice stands in CHANGELOG.md of the source.

 -- The Regista authors <regista@example.org>  @time@
]])
# Without name and time of the file, which gzip would keep.
execute_process(COMMAND gzip -9 -n -f changelog WORKING_DIRECTORY ${folder} COMMAND_ERROR_IS_FATAL ANY)
