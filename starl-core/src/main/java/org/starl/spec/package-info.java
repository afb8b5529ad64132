/**
 * Specifications: a {@link org.starl.spec.Monitor} reads a run's trace events, does not influence
 * the run, and reports violated lemmas. Safety is checked at each event; progress has a deadline
 * that applies while its assumption holds.
 *
 * <p>May import: {@code org.starl} ids, {@code org.starl.geometry}, {@code org.starl.time}, {@code
 * org.starl.trace}.
 */
@NullMarked
package org.starl.spec;

import org.jspecify.annotations.NullMarked;
