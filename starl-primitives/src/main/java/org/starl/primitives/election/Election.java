package org.starl.primitives.election;

import org.starl.GlobalVarHolder;
import org.starl.comms.Channel;
import org.starl.comms.Endpoint;
import org.starl.gvh.GvhCell;
import org.starl.gvh.GvhVariable;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodCodec;
import org.starl.primitives.agreement.SynodPrimitive;
import org.starl.shape.Shapes;
import org.starl.trace.Instance;

/**
 * The election of one robot: {@link ElectionProtocol} on its gvh. A robot that constructs it votes, if
 * it is a participant, and learns the leader; {@link #do_election} makes it a candidate. Strand only.
 */
public final class Election extends SynodPrimitive implements ElectionPrim {

  private final ProcessId me;
  private final Endpoint<ElectionMessage> endpoint;
  private final ElectionProtocol protocol;
  private final GvhCell<Leader> leader;
  private final GvhCell<Boolean> failed;

  /** Among all robots of the deployment. */
  public Election(GlobalVarHolder gvh, String xid) {
    this(gvh, xid, gvh.id.participants());
  }

  /**
   * Among a list of participants, as in the paper.
   *
   * @param participants the same on every robot, for ever; an election needs a majority of them in
   *     reach
   */
  public Election(GlobalVarHolder gvh, String xid, Participants participants) {
    this(gvh, xid, participants, ElectionSettings.DEFAULT);
  }

  public Election(
      GlobalVarHolder gvh, String xid, Participants participants, ElectionSettings settings) {
    super(
        gvh,
        Instance.of(ElectionFact.PRIMITIVE, xid),
        new Channel<>(
            ElectionFact.SYNOD, xid, SynodCodec.of(SynodCodec.Format.of(Shapes.PROCESS))));
    leader = gvh.variable(source, ElectionFact.LEADER, Leader.NONE);
    failed = gvh.variable(source, ElectionFact.FAILED, false);
    me = gvh.id.freshProcess();
    protocol =
        new ElectionProtocol(
            me,
            participants,
            settings,
            gvh.plat.entropy.fork(source.name()),
            wire,
            new Port(),
            gvh.plat.clock.nowNs());
    gvh.trace.action(
        source, ElectionFact.CREATED, new ElectionFact.Created(participants.size(), me));
    endpoint =
        wire.open(
            new Channel<>(ElectionFact.PRIMITIVE, xid, ElectionMessage.SHAPE),
            ElectionMessage::from,
            protocol::received);
    wire.start(protocol, this::show);
  }

  @Override
  public void do_election() {
    gvh.trace.action(source, ElectionFact.DO_ELECTION, new ElectionAction.do_election(me));
    wire.call(protocol::do_election);
  }

  @Override
  public GvhVariable<Leader> Leader() {
    return leader.variable();
  }

  @Override
  public GvhVariable<Boolean> failed() {
    return failed.variable();
  }

  /** This robot's participant: the id that {@link #Leader} shows if this robot is elected. */
  public ProcessId me() {
    return me;
  }

  /** Whether this robot knows that it is the leader. */
  public boolean isLeader() {
    return leader.get() instanceof Leader.Name name && name.id().equals(me);
  }

  private void show() {
    leader.set(protocol.leader());
    failed.set(protocol.leader() instanceof Leader.Fail);
  }

  private final class Port implements ElectionPort {
    @Override
    public void send(RobotId to, ElectionMessage message) {
      endpoint.send(to, message);
    }

    @Override
    public void broadcast(ElectionMessage message) {
      endpoint.broadcast(message);
    }

    @Override
    public void candidate(long term) {
      gvh.trace.action(source, ElectionFact.CANDIDATE, new ElectionAction.candidate(me, term));
    }
  }
}
