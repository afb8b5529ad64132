/**
 * The workloads that StarL measures itself by, over its public API: {@code starl bench b1} is the
 * kernel with strands and radio, {@code b2} the whole stack with motion and positioning. A workload
 * says what it measured, per second of CPU time of the thread that ran it; it passes no judgement.
 *
 * <p>May import: all other modules.
 */
@NullMarked
package org.starl.bench;

import org.jspecify.annotations.NullMarked;
