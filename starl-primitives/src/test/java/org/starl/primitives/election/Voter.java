package org.starl.primitives.election;

import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodCodec;
import org.starl.primitives.agreement.SynodLink;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.chaos.LiveRobot;
import org.starl.random.Rng;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/** One robot of a {@link Convoy}. */
final class Voter extends LiveRobot {

  private static final Shape<SynodMessage> SYNOD_CODEC =
      SynodCodec.of(SynodCodec.Format.of(Shapes.PROCESS));

  private final Convoy convoy;

  Voter(Convoy convoy, RobotId name) {
    super(convoy.world, Convoy.SOURCE, name);
    this.convoy = convoy;
  }

  ElectionProtocol protocol() {
    return ((Ballot) running()).protocol;
  }

  Leader leader() {
    return protocol().leader();
  }

  /** Whether its present program has called do_election. */
  boolean takesPart() {
    return ((Ballot) running()).takesPart;
  }

  void do_election() {
    Ballot ballot = (Ballot) running();
    ballot.call(ballot::do_election);
  }

  @Override
  protected Program program(ProcessId me) {
    return new Ballot(me);
  }

  /** Makes a robot's protocol; mutants make another one. */
  interface Maker {
    ElectionProtocol make(
        ProcessId me,
        Participants participants,
        ElectionSettings settings,
        Rng rng,
        SynodLink link,
        ElectionPort port,
        long nowNs);
  }

  private final class Ballot extends Program implements ElectionPort {
    private final ElectionProtocol protocol;
    private boolean takesPart;

    Ballot(ProcessId me) {
      super(SYNOD_CODEC);
      show(ElectionFact.LEADER, Leader.NONE);
      act(ElectionFact.CREATED, new ElectionFact.Created(convoy.world.robots.size(), me));
      protocol =
          convoy.maker.make(
              me,
              convoy.participants(),
              convoy.settings,
              convoy.world.rng.fork(me.toString()),
              this,
              this,
              convoy.world.nowNs());
    }

    void do_election() {
      takesPart = true;
      act(ElectionFact.DO_ELECTION, new ElectionAction.do_election(protocol.me()));
      protocol.do_election(convoy.world.nowNs());
    }

    @Override
    protected ElectionProtocol protocol() {
      return protocol;
    }

    @Override
    protected void settled() {
      show(ElectionFact.LEADER, protocol.leader());
    }

    @Override
    public void send(RobotId to, ElectionMessage message) {
      transmit(to, message, ElectionMessage.SHAPE, Ballot::receive);
    }

    @Override
    public void broadcast(ElectionMessage message) {
      broadcast(message, ElectionMessage.SHAPE, Ballot::receive);
    }

    private static void receive(Program program, ElectionMessage message) {
      Ballot receiver = (Ballot) program;
      receiver.protocol.received(message, receiver.nowNs());
    }

    private long nowNs() {
      return convoy.world.nowNs();
    }

    @Override
    public void candidate(long term) {
      act(ElectionFact.CANDIDATE, new ElectionAction.candidate(protocol.me(), term));
    }
  }
}
