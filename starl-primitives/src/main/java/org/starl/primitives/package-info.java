/**
 * The primitives of the paper's section 4, one package each: its interface, its algorithm as a pure,
 * clock-driven protocol class, its messages and facts with their shapes, and its specification as
 * monitors over the trace. Each package's documentation is its contract: safety, progress with its bounds, and
 * what it assumes.
 *
 * <p>An implementation keeps its invariants under every fault in its envelope; progress is best
 * effort, and a failure is always reported.
 *
 * <p>May import: core.
 */
@NullMarked
package org.starl.primitives;

import org.jspecify.annotations.NullMarked;
