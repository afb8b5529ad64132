package org.starl.robot.udp;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetSocketAddress;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.statistics.Statistics;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.robot.udp.Beacon.Answer;
import org.starl.session.Nonce;
import org.starl.session.Start;

/** Robots that have lost their storages; beacons are lost, and arrive in random order. */
class LostStorageTest {

  private static final InetSocketAddress SOMEWHERE = new InetSocketAddress("127.0.0.1", 1);
  private static final long SECOND_NS = 1_000_000_000;
  private static final int STEPS = 200;

  /** One start of a robot's program, without sockets. */
  private final class Machine {
    private final RobotId self;
    private final Start start;
    private final Neighbours neighbours;
    private int beacons;
    private final Map<RobotId, Start> stored = new TreeMap<>();
    private boolean isStopped;

    Machine(int robot, long epoch, int boot) {
      self = names.get(robot);
      start = new Start(epoch, boot, new Nonce(1, machines.size() + 1));
      neighbours = new Neighbours(self, start, Participants.of(names), Long.MAX_VALUE, 0);
      machines.add(this);
    }

    void send(RobotId to, Nonce echo, Answer answer) {
      beacons++;
      air.add(new Beacon(self, start, beacons, null, 1, to, echo, answer));
    }

    void hear(Beacon beacon) {
      RobotId from = beacon.robot();
      Nonce nonce = beacon.start().nonce();
      nowNs += SECOND_NS;
      switch (neighbours.hear(beacon, SOMEWHERE, nowNs)) {
        case STARTED -> {
          neighbours.stored(from, beacon.start());
          stored.put(from, beacon.start());
          send(from, nonce, Answer.ACCEPTED);
        }
        case UNPROVEN -> send(from, nonce, Answer.NOT_STORED);
        case REFUSED -> send(from, nonce, neighbours.answerTo(from, beacon.start()));
        case TWIN, REFUSES_US -> isStopped = true;
        case APPEARED, HEARD, OLD, OWN, STRANGE -> {}
      }
    }
  }

  private List<RobotId> names = List.of();
  private final List<Machine> machines = new ArrayList<>();
  private final ArrayDeque<Beacon> air = new ArrayDeque<>();
  private long nowNs;

  /** Each machine sends a beacon to another robot; each of these and its answers reach some machines. */
  private void exchange(Rng rng, int steps) {
    for (int step = 0; step < steps; step++) {
      List<Machine> running = new ArrayList<>(machines);
      running.removeIf(machine -> machine.isStopped);
      Machine from = running.get(rng.nextInt(running.size()));
      RobotId to = names.get(rng.nextInt(names.size()));
      if (!to.equals(from.self)) {
        from.send(to, from.neighbours.echoTo(to), from.neighbours.answerTo(to));
      }
      while (!air.isEmpty()) {
        Beacon beacon = air.poll();
        for (Machine each : running) {
          if (each.self.equals(beacon.to()) && !each.isStopped && rng.nextBoolean(0.7)) {
            each.hear(beacon);
          }
        }
      }
    }
  }

  private void robots(int count) {
    names = IntStream.range(0, count).mapToObj(each -> new RobotId("bot" + each)).toList();
    machines.clear();
    air.clear();
    nowNs = 0;
  }

  /**
   * bot2 has lost its storage, and a second machine runs as bot0 with a storage of its own. All have
   * the one key: bot2 may believe the second bot0.
   */
  @Property(tries = 500)
  @Tag("long")
  void itStopsNoRobotThatTheOthersAccept(@ForAll long seed) {
    robots(3);
    Rng rng = new Rng(seed);
    Machine bot0 = new Machine(0, 10, 3);
    Machine bot1 = new Machine(1, 11, 3);
    bot0.neighbours.remember(bot1.self, new Start(11, 2, new Nonce(2, 1)));
    bot1.neighbours.remember(bot0.self, new Start(10, 2, new Nonce(2, 2)));
    for (Machine each : List.of(bot0, bot1)) {
      each.neighbours.remember(names.get(2), new Start(12, 2, new Nonce(2, 3)));
    }
    while (bot0.neighbours.lastHeardNs(bot1.self) == null) {
      exchange(rng, 1);
    }

    Machine lost = new Machine(2, 22, 1);
    Machine second = new Machine(0, 20, 1);
    exchange(rng, STEPS);

    assertThat(List.of(bot0.isStopped, bot1.isStopped)).as("true").containsOnly(false);
    assertThat(List.of(lost.isStopped, second.isStopped)).as("lost, second").containsOnly(true);
  }

  /**
   * bot0 runs with one storage and then with another, while the others start again and again with
   * theirs, not all at the same time.
   */
  @Property(tries = 1000)
  @Tag("long")
  void ofTwoStoragesOfARobotAtMostOneIsEverKnown(
      @ForAll long seed, @ForAll @IntRange(min = 2, max = 6) int count) {
    robots(count);
    Rng rng = new Rng(seed);
    Map<RobotId, Map<RobotId, Start>> disks = new TreeMap<>();
    List<Boolean> known = new ArrayList<>();
    for (int epoch : List.of(100, 200)) {
      boolean isKnown = false;
      for (int period = 1; period <= 4; period++) {
        machines.clear();
        air.clear();
        Machine mine = new Machine(0, epoch, period);
        for (int other = 1; other < count; other++) {
          if (rng.nextBoolean(0.6)) {
            Machine machine = new Machine(other, other, (epoch / 100) * 4 + period);
            machine.stored.putAll(disks.getOrDefault(machine.self, Map.of()));
            machine.stored.forEach(machine.neighbours::remember);
          }
        }
        exchange(rng, 1 + rng.nextInt(12 * count));
        isKnown |= mine.neighbours.isKnown();
        machines.forEach(machine -> disks.put(machine.self, machine.stored));
      }
      known.add(isKnown);
      disks.remove(names.get(0));
    }

    Statistics.label("first, second storage").collect(known.get(0), known.get(1));
    assertThat(known).as("both storages").isNotEqualTo(List.of(true, true));
  }
}
