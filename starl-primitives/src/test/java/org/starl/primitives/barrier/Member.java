package org.starl.primitives.barrier;

import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodCodec;
import org.starl.primitives.agreement.SynodLink;
import org.starl.primitives.chaos.LiveRobot;
import org.starl.random.Rng;

/** One robot of a {@link Gathering}. */
final class Member extends LiveRobot {

  private final Gathering gathering;

  Member(Gathering gathering, RobotId name) {
    super(gathering.world, Gathering.SOURCE, name);
    this.gathering = gathering;
  }

  BarrierProtocol protocol() {
    return ((Stay) running()).protocol;
  }

  BarrierOutcome outcome() {
    return protocol().outcome();
  }

  void arrive() {
    Stay stay = (Stay) running();
    stay.call(stay::arrive);
  }

  /** Whether it is up and, as far as it knows, still a member. */
  boolean isIn() {
    return isUp()
        && gathering.first().contains(protocol().me())
        && !(outcome() instanceof BarrierOutcome.Excluded);
  }

  @Override
  protected Program program(ProcessId me) {
    return new Stay(me);
  }

  /** Makes a robot's protocol; mutants make another one. */
  interface Maker {
    BarrierProtocol make(
        ProcessId me,
        SortedSet<ProcessId> first,
        BarrierSettings settings,
        Rng rng,
        SynodLink link,
        BarrierPort port,
        long nowNs);
  }

  private final class Stay extends Program implements BarrierPort {
    private final BarrierProtocol protocol;

    Stay(ProcessId me) {
      super(SynodCodec.of(new OutcomesFormat(gathering.first())));
      show(BarrierFact.OUTCOME, BarrierOutcome.NONE_YET);
      protocol =
          gathering.maker.make(
              me,
              gathering.first(),
              gathering.settings,
              gathering.world.rng.fork(me.toString()),
              this,
              this,
              gathering.world.nowNs());
      act(BarrierFact.CREATED, new BarrierFact.Created(me, gathering.first()));
    }

    void arrive() {
      act(BarrierFact.ARRIVE, new BarrierAction.arrive(protocol.me(), protocol.generation()));
      protocol.arrive(gathering.world.nowNs());
    }

    @Override
    protected BarrierProtocol protocol() {
      return protocol;
    }

    @Override
    protected void settled() {
      show(BarrierFact.OUTCOME, protocol.outcome());
    }

    @Override
    public void send(RobotId to, BarrierMessage message) {
      transmit(
          to,
          message,
          BarrierMessage.SHAPE,
          (program, m) -> ((Stay) program).protocol.received(m, gathering.world.nowNs()));
    }
  }
}
