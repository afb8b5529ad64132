/**
 * How the smallest app is drawn: goals, lines to them, and how the motions ended.
 *
 * <p>May import: core, sim, {@code java.awt}.
 */
@NullMarked
package org.starl.apps.hello.view;

import org.jspecify.annotations.NullMarked;
