/**
 * How the smallest app is drawn: goals, ways to them, and how they ended.
 *
 * <p>May import: core, sim, {@code java.awt}.
 */
@NullMarked
package org.starl.apps.hello.view;

import org.jspecify.annotations.NullMarked;
