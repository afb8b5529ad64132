/** The command line, run as a person would, in this process. May import: everything. */
@NullMarked
package org.starl.cli;

import org.jspecify.annotations.NullMarked;
