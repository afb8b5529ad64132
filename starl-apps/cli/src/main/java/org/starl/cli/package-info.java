/**
 * The command line: one small class a command. Exit status 0: good; 1: a specification was violated
 * or a run did not finish; 2: bad input, told in one line; 3: something that the machine lacks.
 *
 * <p>May import: all other modules.
 */
@NullMarked
package org.starl.cli;

import org.jspecify.annotations.NullMarked;
