/**
 * Each robot of a simulation as an operating-system process, over UDP on the loopback interface, in
 * real time. {@link org.starl.processes.Fleet} is the parent's side: starts the processes, ends some of
 * them as the user asks, merges their traces and shows the whole to monitors and observers. {@link
 * org.starl.processes.RobotProcess} is the side of one robot: its program on the real platform, its
 * body simulated.
 *
 * <p>What runs is a {@link org.starl.sim.Blueprint}: parent and children make it alike from the same
 * options and seed, so that nothing but names, ports and times has to be told. The seed decides
 * scenario, losses, delays and draws; when things happen is the machine's.
 *
 * <p><b>The pipes.</b> A child's standard output is its trace, flushed event by event: what it did is
 * out before anybody can know of it, whenever it is killed. Actions of the source {@code process} are
 * meant for the parent and stay out of the merged trace. A child's standard input brings one order a
 * line ({@code Order}); when it ends, for whatever reason, so does the child: none survives its
 * parent.
 *
 * <p><b>Time.</b> All count ns from the parent's {@code begin} on the machine's one monotonic clock;
 * the parent checks that each child's clock is that one.
 *
 * <p><b>Bodies.</b> Each child has a world with its own body and the obstacles: bodies in different
 * processes do not feel each other. While the program is silent for {@code BodyClock.WATCHDOG_NS}, a
 * watchdog holds the wheels. A body appears on the floor when the parent sees room for it, and moves in
 * closed form from one traced change to the next, so that the monitors look at true bodies, not at
 * samples. A killed robot's body stands still from its last sign of life.
 *
 * <p><b>Progress</b> in bounded time is nothing that a machine promises which does other work as well:
 * the merged trace begins with a fault of the world that never ends, so that no monitor holds progress
 * owed. Safety is judged exactly.
 *
 * <p>May import: all modules; not {@code org.starl.apps} nor {@code org.starl.cli}.
 */
@NullMarked
package org.starl.processes;

import org.jspecify.annotations.NullMarked;
