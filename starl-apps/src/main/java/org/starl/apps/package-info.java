/**
 * The apps that come with StarL, one package each: {@code logic} (what runs on robots; core and
 * primitives only), {@code view} (how it is drawn), and beside them its scenarios and
 * specifications. Here: what the command line needs to know of an app.
 *
 * <p>May import: all other modules.
 */
@NullMarked
package org.starl.apps;

import org.jspecify.annotations.NullMarked;
