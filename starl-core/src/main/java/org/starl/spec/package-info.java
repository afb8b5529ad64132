/**
 * What a specification is: a {@link org.starl.spec.Monitor} that reads a run's trace events, decides
 * nothing in the run, and reports where a lemma fails. Safety is a check at an event; bounded
 * progress is owed while its assumption holds.
 *
 * <p>May import: {@code org.starl} ids, {@code org.starl.geometry}, {@code org.starl.trace}.
 */
@NullMarked
package org.starl.spec;

import org.jspecify.annotations.NullMarked;
