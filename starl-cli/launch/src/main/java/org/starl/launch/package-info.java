/**
 * Robots as operating-system processes, in real time: started, watched, killed, and their traces
 * merged and judged. There are two uses:
 *
 * <ul>
 *   <li>{@code starl run --processes}: a {@link org.starl.launch.Launcher} starts each robot of a
 *       simulation as a {@link org.starl.launch.RobotProcess}, over UDP on the loopback interface.
 *   <li>{@code starl deploy}: a {@link org.starl.launch.RobotRun} is one robot of a deployment
 *       file, a {@link org.starl.launch.WorldServer} simulates the bodies of such robots.
 * </ul>
 *
 * <p>Both run a {@link org.starl.sim.SimulationPlan}, which each process makes from the same options
 * and seed: only names, ports and times are exchanged. Both run {@code RobotMain}'s
 * rounds of incarnations, let {@code OneRobotControl} direct one robot, and leave traces that
 * {@link org.starl.launch.TraceMerge} merges by time and cause and shows to the app's monitors.
 * Safety is checked exactly; progress in bounded time is not checked, because a busy machine cannot
 * guarantee it.
 *
 * <p><b>Pipes.</b> A launched robot's standard output is its trace. Each event is flushed before
 * it can affect another process, so a kill loses no event with an effect. Actions of the source
 * {@code process} are for the parent and stay out of the merged trace. Its standard input has
 * one command per line ({@code ParentCommand}); when it ends, for any reason, the process ends: no
 * robot survives its parent.
 *
 * <p><b>Time.</b> Launched processes count ns from the parent's {@code begin} on the machine's
 * monotonic clock; the parent checks that they share it. A deployed process's trace names its
 * machine's clock and date, and {@code ClockBounds} derives which orders are possible.
 *
 * <p><b>Bodies.</b> A launched robot's body is simulated in its own process: bodies of different
 * processes do not touch each other. The parent puts a body on the floor when there is room. It
 * moves in closed form from one traced change to the next, so monitors see true bodies. When the
 * program has not run for {@code BodyClock.WATCHDOG_NS}, a watchdog stops the wheels. The body of a
 * killed robot stays at its last traced position. In a deployment, bodies are in the world server
 * or real; real ones are known by measurement ({@code MeasuredBodies}).
 *
 * <p>May import: all modules; not {@code org.starl.apps} nor {@code org.starl.cli}.
 */
@NullMarked
package org.starl.launch;

import org.jspecify.annotations.NullMarked;
