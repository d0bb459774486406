/* SPDX-License-Identifier: MIT
 * A shared object that is no plugin. */
int regista_plugin(void);
int regista_plugin(void) { return 1; }
