/**
 * The command line: {@link org.starl.cli.Main} and its list of commands. Each package below has the
 * commands of one subject; {@code command} and {@code request} have what they share. Exit status 0:
 * good; 1: a specification was violated, a run did not finish, or an error; 2: bad input, reported in
 * one line; 3: the machine lacks something that the command needs; 4: not decided, as a part was not
 * looked at.
 *
 * <p>May import: all other modules.
 */
@NullMarked
package org.starl.cli;

import org.jspecify.annotations.NullMarked;
