/**
 * The app as robots run it: its {@link org.starl.apps.AppFactory}, and the places that it draws from
 * the seed, equal on all robots and in the simulator.
 *
 * <p>May import: core, input, primitives, {@code logic} and {@code spec} beside it, {@code
 * org.starl.apps}.
 */
@NullMarked
package org.starl.apps.hello.robot;

import org.jspecify.annotations.NullMarked;
