/**
 * The apps of StarL, one package each: {@code logic} is the program of the robots (core and
 * primitives only), {@code view} draws it, and beside them are its scenarios and specifications.
 * This package has the types by which the command line runs an app.
 *
 * <p>May import: all other modules.
 */
@NullMarked
package org.starl.apps;

import org.jspecify.annotations.NullMarked;
