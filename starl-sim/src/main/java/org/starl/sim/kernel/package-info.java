/**
 * The deterministic discrete-event kernel: one queue of events in the total order (virtual time,
 * scheduling number), and one {@link org.starl.sim.kernel.SimStrand} per robot, on which the
 * robot's pieces run one at a time and its app may wait.
 *
 * <p>Contract: equal calls give equal orders, for every {@link org.starl.sim.kernel.CarrierKind};
 * no piece of a closed strand runs; a closed kernel has unwound every app. A kernel and its strands
 * belong to the thread that calls {@link org.starl.sim.kernel.Kernel#run}; several kernels may run
 * in parallel. The kernel does not depend on robots, radios, worlds, faults or observers.
 *
 * <p>May import: the JDK, {@code org.starl.platform}.
 */
@NullMarked
package org.starl.sim.kernel;

import org.jspecify.annotations.NullMarked;
