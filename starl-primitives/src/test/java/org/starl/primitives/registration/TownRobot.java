package org.starl.primitives.registration;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodCodec;
import org.starl.primitives.agreement.SynodLink;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;
import org.starl.primitives.registration.RegistrationProtocol.Phase;
import org.starl.random.Rng;
import org.starl.shape.Shape;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;
import org.starl.trace.TraceEvent;
import org.starl.trace.Var;

/** One robot of a {@link Town}: its disk, which survives, and its program, which may not. */
final class TownRobot {

  private static final Shape<SynodMessage> CODEC = SynodCodec.of(new ViewFormat());
  private static final int RELIABLE_TRIES = 15;

  private final Town town;
  final RobotId name;
  private byte @Nullable [] disk;
  private int boot;

  private @Nullable Program program;
  boolean wantsIn;

  TownRobot(Town town, RobotId name) {
    this.town = town;
    this.name = name;
  }

  boolean isUp() {
    return program != null;
  }

  RegistrationProtocol protocol() {
    return running().protocol;
  }

  void start() {
    boot++;
    byte[] found = town.acceptorsForget ? null : disk;
    program = new Program(boot, found == null ? null : found.clone());
    running().settled();
  }

  void crash() {
    program = null;
  }

  void do_register() {
    running().call(() -> protocol().do_register(town.nowNs()));
  }

  void unregister() {
    running().call(() -> protocol().unregister(town.nowNs()));
  }

  /** Proposes to confine a robot on its list, as if it had fenced it; only if it is on the list itself. */
  void confine(Rng rng) {
    Program up = program;
    if (up == null || up.protocol.phase() != Phase.IN) {
      return;
    }
    List<ProcessId> others = new ArrayList<>(up.protocol.view().mentioned());
    others.remove(up.protocol.me());
    if (!others.isEmpty()) {
      ProcessId peer = others.get(rng.nextInt(others.size()));
      List<String> sections = new ArrayList<>(List.of("A", "B", "C"));
      sections.removeIf(each -> rng.nextBoolean(0.5));
      Confinement confinement =
          new Confinement(peer, new TreeSet<>(sections), new TreeSet<>(List.of(up.protocol.me())));
      up.call(() -> up.protocol.confine(confinement, town.nowNs()));
    }
  }

  /** Says of its older ids that they are done: those of this start, and those of earlier ones. */
  void tidy() {
    Program up = program;
    if (up != null) {
      List<ProcessId> mine = new ArrayList<>(up.mine);
      if (up.protocol.phase() != Phase.OUT) {
        mine.remove(up.protocol.me());
      }
      mine.forEach(id -> up.call(() -> up.protocol.markIdle(id, town.nowNs())));
      up.call(() -> up.protocol.standsIn(new TreeSet<>(), town.nowNs()));
    }
  }

  boolean isSatisfied() {
    Program up = program;
    if (up == null) {
      return false;
    }
    return wantsIn
        ? up.protocol.phase() == Phase.IN && up.protocol.rList().isAgreed()
        : up.protocol.phase() == Phase.OUT;
  }

  /** Calls what leads to what it wants, if nothing is under way. */
  void pursue() {
    Program up = program;
    if (up == null) {
      return;
    }
    Phase phase = up.protocol.phase();
    if (wantsIn && (phase == Phase.OUT || phase == Phase.LEFT_HALFWAY)) {
      do_register();
    } else if (!wantsIn && (phase == Phase.IN || phase == Phase.LEFT_HALFWAY)) {
      unregister();
    }
  }

  private Program running() {
    Program up = program;
    if (up == null) {
      throw new IllegalStateException(name + " is down");
    }
    return up;
  }

  private static SynodMessage overTheWire(SynodMessage message) {
    byte[] buffer = new byte[1400];
    WireWriter out = new WireWriter(buffer);
    CODEC.write(message, out);
    WireReader in = new WireReader(Arrays.copyOf(buffer, out.length()));
    SynodMessage read = CODEC.read(in);
    if (in.remaining() != 0 || !read.equals(message)) {
      throw new IllegalStateException(message + " came back as " + read);
    }
    return read;
  }

  private final class Program implements RegistrationPort, SynodLink {
    private final byte @Nullable [] record;
    private final int itsBoot;
    private final RegistrationProtocol protocol;
    private final List<ProcessId> mine = new ArrayList<>();
    private int handedOut;
    private long timerSetForNs = Long.MAX_VALUE;
    private long lastFlushNs;
    private View shownView = View.NONE;
    private RList shownList = RList.UNKNOWN;
    private boolean shownFailed;

    Program(int itsBoot, byte @Nullable [] record) {
      this.itsBoot = itsBoot;
      this.record = record;
      show(RegistrationFact.VIEW, View.NONE);
      show(RegistrationFact.R_LIST, RList.UNKNOWN);
      show(RegistrationFact.FAILED, false);
      protocol =
          town.maker.make(
              name,
              town.acceptors,
              town.settings,
              town.rng.fork(name + "/" + town.nowNs()),
              this,
              this,
              town.nowNs());
    }

    boolean isCurrent() {
      return program == this;
    }

    void call(Runnable input) {
      input.run();
      settled();
    }

    void settled() {
      if (shownView.number() != protocol.view().number()) {
        shownView = protocol.view();
        show(RegistrationFact.VIEW, shownView);
      }
      if (!shownList.equals(protocol.rList())) {
        shownList = protocol.rList();
        show(RegistrationFact.R_LIST, shownList);
      }
      if (shownFailed != protocol.hasFailed()) {
        shownFailed = protocol.hasFailed();
        show(RegistrationFact.FAILED, shownFailed);
      }
      long wakeAtNs = protocol.wakeAtNs();
      if (wakeAtNs != timerSetForNs) {
        timerSetForNs = wakeAtNs;
        if (wakeAtNs != Long.MAX_VALUE) {
          town.at(wakeAtNs, () -> timer(wakeAtNs));
        }
      }
    }

    private void timer(long setForNs) {
      if (isCurrent() && timerSetForNs == setForNs) {
        timerSetForNs = Long.MAX_VALUE;
        call(() -> protocol.timer(town.nowNs()));
      }
    }

    private void receive(RobotId from, SynodMessage message) {
      call(() -> protocol.received(from, message, town.nowNs()));
    }

    @Override
    public byte @Nullable [] record() {
      return record;
    }

    @Override
    public void send(RobotId to, SynodMessage message) {
      SynodMessage read = town.tamper.apply(overTheWire(message));
      TownRobot receiver = town.robots.get(to);
      town.transmit(name, to, () -> receiver.arrived(name, read));
    }

    @Override
    public void sendReliably(RobotId to, SynodMessage message, Runnable settled) {
      if (!town.newsIsLost) {
        retry(to, overTheWire(message), new boolean[1], RELIABLE_TRIES, settled);
      }
    }

    private void retry(
        RobotId to, SynodMessage message, boolean[] done, int tries, Runnable settled) {
      if (!isCurrent()) {
        return;
      }
      if (done[0] || tries == 0) {
        call(settled);
        return;
      }
      TownRobot receiver = town.robots.get(to);
      town.transmit(
          name,
          to,
          () -> {
            // No robot has the name that stands in ballots which collide.
            if (!done[0] && receiver != null && receiver.isUp()) {
              done[0] = true;
              receiver.arrived(name, message);
            }
          });
      town.afterMs(500, () -> retry(to, message, done, tries - 1, settled));
    }

    @Override
    public void persist(long version, byte[] record) {
      long flushMs = town.rng.nextLong(0, town.weather.maxFlushMs());
      lastFlushNs = Math.max(lastFlushNs, town.nowNs() + flushMs * Town.NS_PER_MS);
      byte[] written = record.clone();
      town.at(
          lastFlushNs,
          () -> {
            if (isCurrent()) {
              disk = written;
            }
          });
      town.at(town.flushesLie ? town.nowNs() : lastFlushNs, () -> flushed(version));
    }

    private void flushed(long version) {
      if (isCurrent()) {
        call(() -> protocol.flushed(version, town.nowNs()));
      }
    }

    @Override
    public ProcessId freshProcess() {
      handedOut++;
      if (town.ballotsCollide && handedOut == 1) {
        return ProcessId.first(new RobotId("everybody"), 1);
      }
      ProcessId id = new ProcessId(name, ((long) itsBoot << 32) + handedOut);
      mine.add(id);
      return id;
    }

    @Override
    public void acted(RegistrationAction action) {
      town.record(
          TraceEvent.Action.of(town.nowNs(), name, Town.SOURCE, RegistrationFact.ACTIONS, action));
    }

    @Override
    public void confines(Confinement confinement) {
      town.record(
          TraceEvent.Action.of(
              town.nowNs(), name, Town.SOURCE, RegistrationFact.CONFINE, confinement));
    }

    private <T> void show(Var<T> variable, T value) {
      town.record(new TraceEvent.Variable(town.nowNs(), name, Town.SOURCE, variable, value));
    }
  }

  private void arrived(RobotId from, SynodMessage message) {
    Program up = program;
    if (up != null) {
      up.receive(from, message);
    }
  }
}
