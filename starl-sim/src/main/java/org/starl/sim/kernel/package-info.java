/**
 * The deterministic discrete-event kernel: one queue of events in the total order (virtual time,
 * number of scheduling), and one {@link org.starl.sim.kernel.SimStrand} a robot, on which the
 * robot's pieces run one at a time and its app may wait.
 *
 * <p>Contract: equal calls give equal orders, whichever {@link org.starl.sim.kernel.CarrierKind}
 * carries the waiting apps; nothing of a closed strand runs; a closed kernel has unwound every app.
 * A kernel and its strands belong to the one thread that calls {@link
 * org.starl.sim.kernel.Kernel#run}; several kernels may run side by side. The kernel knows no
 * robot, radio, world, fault or observer.
 *
 * <p>May import: the JDK, {@code org.starl.platform}.
 */
@NullMarked
package org.starl.sim.kernel;

import org.jspecify.annotations.NullMarked;
