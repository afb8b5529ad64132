package org.starl.robot.udp;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;
import org.jspecify.annotations.Nullable;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.platform.DeploymentKey;
import org.starl.random.Rng;
import org.starl.robot.udp.Beacon.Answer;
import org.starl.session.Nonce;
import org.starl.session.Session;
import org.starl.session.Start;

/**
 * Random schedules of two robots that start again, lose their storage or run on two machines, and of an
 * attacker without a key that delivers anything that was ever sent, in any order and to any machine. The
 * code that decides is the program's own; only sockets and time are missing.
 */
class SessionsTest {

  private static final RobotId A = new RobotId("a");
  private static final RobotId B = new RobotId("b");
  private static final Participants BOTH = Participants.of(List.of(A, B));
  private static final DeploymentKey KEY = key();
  private static final InetSocketAddress SOMEWHERE = new InetSocketAddress("127.0.0.1", 1);
  private static final int STEPS = 400;
  private static final int HEADER = 4;

  private static DeploymentKey key() {
    byte[] secret = new byte[DeploymentKey.BYTES];
    secret[0] = 1;
    return new DeploymentKey(secret);
  }

  /** A robot's stable storage. */
  private static final class Storage {
    private final long epoch;
    private int boots;
    private final Map<RobotId, Start> latest = new HashMap<>();

    Storage(long epoch) {
      this.epoch = epoch;
    }

    Storage copy() {
      Storage copy = new Storage(epoch);
      copy.boots = boots;
      copy.latest.putAll(latest);
      return copy;
    }
  }

  /** A beacon or a datagram, as the attacker has recorded it. */
  private record Recording(
      Machine from, RobotId to, @Nullable Start receiver, @Nullable Beacon beacon, byte[] sealed) {}

  /** One start of a robot's program. */
  private final class Machine {
    private final RobotId self;
    private final Storage storage;
    private final Start start;
    private final Neighbours neighbours;
    private final Map<RobotId, Session> sessions = new HashMap<>();
    private final Map<RobotId, Start> sessionsWith = new HashMap<>();
    private int beacons;
    private boolean isStopped;

    Machine(RobotId self, Storage storage) {
      this.self = self;
      this.storage = storage;
      storage.boots++;
      nonces++;
      start = new Start(storage.epoch, storage.boots, new Nonce(1, nonces));
      neighbours = new Neighbours(self, start, BOTH, Long.MAX_VALUE, 0);
      storage.latest.forEach(neighbours::remember);
    }

    RobotId peer() {
      return self.equals(A) ? B : A;
    }

    void beacon(RobotId to, Nonce echo, Answer answer) {
      beacons++;
      Beacon beacon = new Beacon(self, start, beacons, null, 1, to, echo, answer);
      air.add(new Recording(this, to, null, beacon, new byte[0]));
    }

    void datagram() {
      Session session = sessions.get(peer());
      if (session != null) {
        byte[] sealed = new byte[HEADER + 1 + Session.BYTES];
        session.seal(new byte[HEADER + 1], HEADER, HEADER + 1, sealed);
        air.add(new Recording(this, peer(), sessionsWith.get(peer()), null, sealed));
      }
    }

    void receive(Recording recording) {
      if (isStopped) {
        return;
      }
      if (recording.beacon != null) {
        hear(recording.beacon);
      } else {
        open(recording);
      }
    }

    void prove() {
      beacon(peer(), neighbours.echoTo(peer()), neighbours.answerTo(peer()));
    }

    private void hear(Beacon beacon) {
      now += 1_000_000_000;
      switch (neighbours.hear(beacon, SOMEWHERE, now)) {
        case STARTED -> {
          Start before = sessionsWith.put(beacon.robot(), beacon.start());
          assertThat(before == null || before.boot() < beacon.start().boot())
              .as("seed %d: %s after %s", seed, beacon.start(), before)
              .isTrue();
          storage.latest.put(beacon.robot(), beacon.start());
          neighbours.stored(beacon.robot(), beacon.start());
          sessions.put(
              beacon.robot(),
              new Session(KEY.pairKey(A, B), self, start, beacon.robot(), beacon.start()));
          beacon(beacon.robot(), beacon.start().nonce(), Answer.ACCEPTED);
        }
        case UNPROVEN -> beacon(beacon.robot(), beacon.start().nonce(), Answer.NOT_STORED);
        case REFUSED ->
            beacon(
                beacon.robot(),
                beacon.start().nonce(),
                neighbours.answerTo(beacon.robot(), beacon.start()));
        case TWIN -> {
          assertThat(haveTwins(self)).as("seed %d: a recording stops a robot", seed).isTrue();
          beacon(self, beacon.start().nonce(), Answer.NOT_STORED);
          isStopped = true;
          stopped++;
        }
        case REFUSES_US -> {
          assertThat(mayBeRefused(this)).as("seed %d: a recording stops a robot", seed).isTrue();
          isStopped = true;
          stopped++;
        }
        case APPEARED, HEARD, OLD, OWN, STRANGE -> {}
      }
    }

    private void open(Recording recording) {
      Session session = sessions.get(recording.from.self);
      byte[] sealed = recording.sealed;
      boolean isAccepted =
          session != null
              && session.isOf(sealed, sealed.length)
              && session.open(sealed, HEADER, sealed.length, new byte[sealed.length]);
      if (isAccepted) {
        accepted++;
        assertThat(recording.to).isEqualTo(self);
        assertThat(recording.from.start)
            .as("seed %d: a datagram of another start", seed)
            .isEqualTo(sessionsWith.get(recording.from.self));
        assertThat(recording.receiver)
            .as("seed %d: a datagram to another start", seed)
            .isEqualTo(start);
      }
    }
  }

  private final List<Recording> air = new ArrayList<>();
  private final List<Machine> all = new ArrayList<>();
  private final Map<RobotId, Machine> running = new HashMap<>();
  private final Map<RobotId, Machine> twins = new HashMap<>();
  private long seed;
  private long nonces;
  private long epochs;
  private long now;
  private int accepted;
  private int stopped;

  /** Whether two machines ran this robot at one time. */
  private boolean haveTwins(RobotId robot) {
    return twins.containsKey(robot);
  }

  /** Whether that start is on a second machine, or with a storage that another robot does not know. */
  private boolean mayBeRefused(Machine machine) {
    return haveTwins(machine.self)
        || all.stream()
            .anyMatch(other ->
                other.self.equals(machine.self) && other.storage.epoch != machine.storage.epoch);
  }

  @Property(tries = 300)
  void noScheduleOfRestartsAndRecordingsOpensAnOldSession(@ForAll long drawn) {
    run(drawn, true);
  }

  /** Without second machines and lost storage no recording stops a robot, and datagrams arrive. */
  @Property(tries = 100)
  @Tag("long")
  void recordingsStopNoRobot(@ForAll long drawn) {
    run(drawn, false);
    assertThat(stopped).as("seed %d", seed).isZero();

    // A network that works for a while is enough for both to hear each other again.
    for (RobotId robot : List.of(A, B, A, B)) {
      Machine machine = running.get(robot);
      machine.prove();
      deliverLast();
    }
    for (RobotId robot : List.of(A, B)) {
      accepted = 0;
      running.get(robot).datagram();
      deliverLast();
      assertThat(accepted).as("seed %d", seed).isEqualTo(1);
    }
  }

  /** Delivers the last beacon or datagram, and each beacon that answers it. */
  private void deliverLast() {
    for (int next = air.size() - 1; next < air.size(); next++) {
      running.get(air.get(next).to).receive(air.get(next));
    }
  }

  private void run(long drawn, boolean withTwins) {
    air.clear();
    all.clear();
    running.clear();
    twins.clear();
    seed = drawn;
    stopped = 0;
    accepted = 0;
    Rng rng = new Rng(drawn);
    start(A, new Storage(++epochs));
    start(B, new Storage(++epochs));
    for (int step = 0; step < STEPS; step++) {
      Machine machine = all.get(Math.max(0, all.size() - 1 - rng.nextInt(4)));
      RobotId robot = machine.self;
      boolean isUp = running.get(robot) == machine || twins.get(robot) == machine;
      int choice = rng.nextInt(100);
      if (choice < 4) {
        start(robot, running.getOrDefault(robot, machine).storage);
      } else if (choice < 5 && withTwins) {
        start(robot, new Storage(++epochs));
      } else if (choice < 7 && withTwins) {
        twin(robot);
      } else if (choice < 30 && isUp && !machine.isStopped) {
        machine.prove();
      } else if (choice < 45 && isUp && !machine.isStopped) {
        machine.datagram();
      } else if (!air.isEmpty()) {
        // Mostly something new; also anything old, to any machine.
        int at =
            rng.nextBoolean(0.6)
                ? air.size() - 1 - rng.nextInt(Math.min(4, air.size()))
                : rng.nextInt(air.size());
        Recording recording = air.get(at);
        Machine to = rng.nextBoolean(0.8) ? running.get(recording.to) : any(rng);
        if (to != null) {
          to.receive(recording);
        }
      }
    }
  }

  private @Nullable Machine any(Rng rng) {
    List<Machine> up = new ArrayList<>(running.values());
    up.addAll(twins.values());
    return up.get(rng.nextInt(up.size()));
  }

  private void start(RobotId robot, Storage storage) {
    Machine machine = new Machine(robot, storage);
    running.put(robot, machine);
    all.add(machine);
  }

  private void twin(RobotId robot) {
    Machine original = running.get(robot);
    if (original != null) {
      Machine machine = new Machine(robot, original.storage.copy());
      twins.put(robot, machine);
      all.add(machine);
    }
  }
}
