package org.starl.sim.fault;

import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.sim.net.NetworkTap;

/** An {@link AttackFault} in progress. */
final class Attack {

  private final AttackFault harm;
  private final FaultTarget ward;
  private final Eavesdropper heard;
  private final NetworkTap.Handle tap;
  private boolean isOver;

  Attack(AttackFault harm, FaultContext onset) {
    this.harm = harm;
    ward = onset.ward();
    heard = new Eavesdropper(onset.rng().fork("bytes"));
    tap = ward.network().listen(heard);
    for (RobotId robot : onset.whom()) {
      goOn(robot, onset.rng().fork(robot.name()));
    }
  }

  void end() {
    isOver = true;
    tap.remove();
  }

  private void goOn(RobotId robot, Rng rng) {
    long waitNs = 1 + Math.round(harm.meanNs() * rng.nextExponential());
    ward.at(
        ward.nowNs() + waitNs,
        () -> {
          if (!isOver) {
            byte[] datagram = harm.next(heard);
            if (datagram.length > 0) {
              ward.network().inject(robot, datagram);
            }
            goOn(robot, rng);
          }
        });
  }
}
