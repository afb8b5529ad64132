package org.starl.primitives.barrier;

import java.util.SortedSet;
import java.util.TreeSet;
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
import org.starl.primitives.membership.Membership;
import org.starl.primitives.membership.View;
import org.starl.trace.Instance;

/**
 * The barrier of one robot: {@link BarrierProtocol} on its gvh. A robot that constructs it votes, if it
 * is a member, and answers the others. Strand only.
 */
public final class Barrier extends SynodPrimitive implements BarrierPrim {

  private final Endpoint<BarrierMessage> endpoint;
  private final BarrierProtocol protocol;
  private final GvhCell<BarrierOutcome> outcome;

  /** Among all robots of the deployment; see the other constructors. */
  public Barrier(GlobalVarHolder gvh, String xid) {
    this(gvh, xid, gvh.id.participants());
  }

  /**
   * Among a fixed group. A robot whose program has restarted is no member: it has another id, and does
   * not know in which generation it was.
   *
   * @param members the same on every robot
   * @throws IllegalStateException if this start of the robot's program has opened this instance before
   */
  public Barrier(GlobalVarHolder gvh, String xid, Participants members) {
    this(gvh, xid, members, BarrierSettings.DEFAULT);
  }

  public Barrier(GlobalVarHolder gvh, String xid, Participants members, BarrierSettings settings) {
    this(gvh, xid, ProcessId.first(gvh.id.name(), gvh.id.boot()), View.closed(members), settings);
  }

  /**
   * Among the robots registered now. The view's number is part of the instance, so robots with another
   * view meet in another barrier: after a change of the view, make a new one.
   *
   * @param xid with the view's number at most 31 characters
   * @throws IllegalStateException if this robot is not registered, or its program has opened the
   *     barrier of this view before
   */
  public Barrier(GlobalVarHolder gvh, String xid, Membership membership, BarrierSettings settings) {
    this(
        gvh,
        xid + "." + registered(membership).number(),
        membership.me(),
        membership.view(),
        settings);
  }

  private Barrier(
      GlobalVarHolder gvh, String instance, ProcessId me, View group, BarrierSettings settings) {
    this(gvh, instance, me, new TreeSet<>(group.ids()), settings);
  }

  private Barrier(
      GlobalVarHolder gvh,
      String instance,
      ProcessId me,
      SortedSet<ProcessId> first,
      BarrierSettings settings) {
    super(
        gvh,
        firstInstance(gvh, Instance.of(BarrierFact.PRIMITIVE, instance)),
        new Channel<>(BarrierFact.SYNOD, instance, SynodCodec.of(new OutcomesFormat(first))));
    outcome = gvh.variable(source, BarrierFact.OUTCOME, BarrierOutcome.NONE_YET);
    protocol =
        new BarrierProtocol(
            me,
            first,
            settings,
            gvh.plat.entropy.fork(source.name()),
            wire,
            this::send,
            gvh.plat.clock.nowNs());
    gvh.trace.action(source, BarrierFact.CREATED, new BarrierFact.Created(me, first));
    endpoint =
        wire.open(
            new Channel<>(BarrierFact.PRIMITIVE, instance, BarrierMessage.SHAPE),
            BarrierMessage::from,
            protocol::received);
    wire.start(protocol, this::show);
  }

  private static Instance firstInstance(GlobalVarHolder gvh, Instance source) {
    gvh.requireFirstInstance(source);
    return source;
  }

  private static View registered(Membership membership) {
    if (!membership.mayRequest()) {
      throw new IllegalStateException("a barrier among registered robots: register first");
    }
    return membership.view();
  }

  @Override
  public void arrive() {
    gvh.trace.action(
        source, BarrierFact.ARRIVE, new BarrierAction.arrive(protocol.me(), protocol.generation()));
    wire.call(protocol::arrive);
  }

  @Override
  public GvhVariable<BarrierOutcome> outcome() {
    return outcome.variable();
  }

  @Override
  public long generation() {
    return protocol.generation();
  }

  private void send(RobotId to, BarrierMessage message) {
    endpoint.send(to, message);
  }

  private void show() {
    outcome.set(protocol.outcome());
  }
}
