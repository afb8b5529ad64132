package org.starl.sim.fault;

import java.util.function.Function;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.sim.net.NetworkTap;

/** An attacker without the deployment's key, while its fault lasts. */
final class Attack {

  private final FaultTarget target;
  private final long meanNs;
  private final Function<Eavesdropper, byte[]> next;
  private final Eavesdropper heard;
  private final NetworkTap.Handle tap;
  private boolean isOver;

  /**
   * @param meanNs mean time between two attacks on one robot; the times are exponential
   * @param next the next datagram to send; its length is 0 before the first recording
   */
  Attack(FaultContext context, long meanNs, Function<Eavesdropper, byte[]> next) {
    target = context.target();
    this.meanNs = meanNs;
    this.next = next;
    heard = new Eavesdropper(context.rng().fork("bytes"));
    tap = target.network().listen(heard);
    for (RobotId robot : context.robots()) {
      schedule(robot, context.rng().fork(robot.name()));
    }
  }

  void end() {
    isOver = true;
    tap.remove();
  }

  private void schedule(RobotId robot, Rng rng) {
    long waitNs = 1 + Math.round(meanNs * rng.nextExponential());
    target.at(
        target.nowNs() + waitNs,
        () -> {
          if (!isOver) {
            byte[] datagram = next.apply(heard);
            if (datagram.length > 0) {
              target.network().inject(robot, datagram);
            }
            schedule(robot, rng);
          }
        });
  }
}
