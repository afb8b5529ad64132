package org.starl.primitives.registration;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.comms.Channel;
import org.starl.gvh.GvhCell;
import org.starl.gvh.GvhVariable;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.platform.Waits;
import org.starl.primitives.agreement.AgreementFact;
import org.starl.primitives.agreement.SynodCodec;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.agreement.SynodPrimitive;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.Membership;
import org.starl.primitives.membership.View;
import org.starl.time.Time;
import org.starl.trace.Instance;

/**
 * The registration of one robot: {@link RegPrim} for its app, {@link Membership} for the mutex. A robot
 * that constructs it serves as an acceptor, if it is one, whether it registers or not. Strand only.
 */
public final class Registration extends SynodPrimitive implements RegPrim, Membership {

  /** Pause after a failed call. */
  private static final long RETRY_MS = 500;

  private final RegistrationProtocol protocol;
  private final GvhCell<RList> rList;
  private final GvhCell<Boolean> failed;
  private final GvhCell<Boolean> unregistered;
  private final GvhCell<View> view;
  private final List<Runnable> listeners = new ArrayList<>();
  private ProcessId shownMe;
  private boolean shownMayRequest;
  private @Nullable Member member;

  /** With all robots of the deployment as acceptors. */
  public Registration(GlobalVarHolder gvh, String xid) {
    this(gvh, xid, gvh.id.participants());
  }

  /**
   * @param acceptors the same on every robot, for ever; registering and unregistering need a majority
   *     of them in reach
   */
  public Registration(GlobalVarHolder gvh, String xid, Participants acceptors) {
    this(gvh, xid, acceptors, RegistrationSettings.DEFAULT);
  }

  public Registration(
      GlobalVarHolder gvh, String xid, Participants acceptors, RegistrationSettings settings) {
    super(
        gvh,
        Instance.of(RegistrationFact.PRIMITIVE, xid),
        new Channel<>(RegistrationFact.PRIMITIVE, xid, SynodCodec.of(new ViewFormat())));
    rList = gvh.variable(source, RegistrationFact.R_LIST, RList.UNKNOWN);
    failed = gvh.variable(source, RegistrationFact.FAILED, false);
    unregistered = gvh.variable(source, RegistrationFact.UNREGISTERED, false);
    view = gvh.variable(source, RegistrationFact.VIEW, View.NONE);
    gvh.trace.action(
        source, AgreementFact.ACCEPTORS, new AgreementFact.Acceptors(acceptors.asList()));
    protocol =
        new RegistrationProtocol(
            gvh.id.name(),
            acceptors,
            settings,
            gvh.plat.entropy.fork(source.name()),
            wire,
            new Port(),
            gvh.plat.clock.nowNs());
    shownMe = protocol.me();
    wire.start(protocol, this::show);
    gvh.publish(Membership.class, xid, this);
  }

  @Override
  public void do_register() {
    wire.call(protocol::do_register);
  }

  @Override
  public boolean register(long timeoutMs) {
    return registering(timeoutMs).block(gvh.plat.strand);
  }

  @Override
  public Waits<Boolean> registering(long timeoutMs) {
    return new Waits<>(call -> register(call, timeoutMs, call::end));
  }

  @Override
  public void register(Waits<?> call, long timeoutMs, Consumer<Boolean> then) {
    registerUntil(call, Time.afterMs(gvh.plat.clock.nowNs(), timeoutMs), then);
  }

  private void registerUntil(Waits<?> call, long untilNs, Consumer<Boolean> then) {
    if (mayRequest() || gvh.plat.clock.nowNs() >= untilNs) {
      then.accept(mayRequest());
      return;
    }
    do_register();
    call.until(
        () -> mayRequest() || failed.get(),
        untilNs,
        held -> {
          if (mayRequest()) {
            then.accept(true);
          } else {
            long againNs = Time.afterMs(gvh.plat.clock.nowNs(), RETRY_MS);
            call.until(
                null, Math.min(againNs, untilNs), slept -> registerUntil(call, untilNs, then));
          }
        });
  }

  @Override
  public void unregister() {
    protocol.requireMayUnregister();
    Member told = member;
    if (told != null) {
      told.prepareToLeave();
    }
    wire.call(protocol::unregister);
  }

  @Override
  public boolean isUnregistered() {
    return protocol.isUnregistered();
  }

  @Override
  public @Nullable Participants getList() {
    return rList.get() instanceof RList.Agreed agreed ? agreed.list() : null;
  }

  @Override
  public GvhVariable<RList> rList() {
    return rList.variable();
  }

  @Override
  public long ts() {
    return protocol.view().number();
  }

  @Override
  public GvhVariable<Boolean> failed() {
    return failed.variable();
  }

  @Override
  public ProcessId me() {
    return protocol.me();
  }

  @Override
  public View view() {
    return protocol.view();
  }

  @Override
  public boolean mayRequest() {
    return protocol.phase() == RegistrationProtocol.Phase.IN;
  }

  @Override
  public void onChange(Runnable listener) {
    listeners.add(listener);
  }

  @Override
  public void join(Member newMember) {
    if (member != null) {
      throw new IllegalStateException(
          source + " has a mutex already: give each one a registration of its own");
    }
    member = newMember;
  }

  @Override
  public boolean confines() {
    return true;
  }

  @Override
  public void propose(Confinement confinement) {
    wire.call(nowNs -> protocol.confine(confinement, nowNs));
  }

  @Override
  public void markIdle(ProcessId id) {
    wire.call(nowNs -> protocol.markIdle(id, nowNs));
  }

  @Override
  public void standsIn(SortedSet<String> sections) {
    wire.call(nowNs -> protocol.standsIn(sections, nowNs));
  }

  @Override
  public void refresh() {
    wire.call(protocol::refresh);
  }

  private void show() {
    boolean changed =
        protocol.view().number() != view.get().number()
            || !protocol.me().equals(shownMe)
            || mayRequest() != shownMayRequest;
    shownMe = protocol.me();
    shownMayRequest = mayRequest();
    view.set(protocol.view());
    rList.set(protocol.rList());
    failed.set(protocol.hasFailed());
    unregistered.set(protocol.isUnregistered());
    if (changed) {
      for (Runnable listener : List.copyOf(listeners)) {
        listener.run();
      }
    }
  }

  private final class Port implements RegistrationPort {
    @Override
    public void sendReliably(RobotId to, SynodMessage message, Runnable settled) {
      wire.sendReliably(to, message, settled);
    }

    @Override
    public ProcessId freshProcess() {
      return gvh.id.freshProcess();
    }

    @Override
    public void acted(RegistrationAction action) {
      gvh.trace.action(source, RegistrationFact.ACTIONS, action);
    }

    @Override
    public void confines(Confinement confinement) {
      gvh.trace.action(source, RegistrationFact.CONFINE, confinement);
    }
  }
}
