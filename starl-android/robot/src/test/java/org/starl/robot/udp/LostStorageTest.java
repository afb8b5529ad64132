package org.starl.robot.udp;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetSocketAddress;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.robot.udp.Beacon.Answer;
import org.starl.session.Nonce;
import org.starl.session.Start;

/**
 * bot2 has lost its storage, and a second machine runs as bot0 with a storage of its own. All have the
 * one key, and beacons arrive in random order: bot2 may believe the second bot0.
 */
class LostStorageTest {

  private static final List<RobotId> NAMES =
      List.of(new RobotId("bot0"), new RobotId("bot1"), new RobotId("bot2"));
  private static final Participants ALL = Participants.of(NAMES);
  private static final InetSocketAddress SOMEWHERE = new InetSocketAddress("127.0.0.1", 1);
  private static final long SECOND_NS = 1_000_000_000;
  private static final int STEPS = 200;

  /** One start of a robot's program, without sockets. */
  private final class Machine {
    private final RobotId self;
    private final Start start;
    private final Neighbours neighbours;
    private int beacons;
    private boolean isStopped;

    Machine(int robot, long epoch, int boot) {
      self = NAMES.get(robot);
      start = new Start(epoch, boot, new Nonce(1, machines.size() + 1));
      neighbours = new Neighbours(self, start, ALL, Long.MAX_VALUE, 0);
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
        case STARTED, UNPROVEN -> send(from, nonce, Answer.ACCEPTED);
        case REFUSED -> send(from, nonce, neighbours.answerTo(from, beacon.start()));
        case TWIN, REFUSES_US -> isStopped = true;
        case APPEARED, HEARD, OLD, OWN, STRANGE -> {}
      }
    }
  }

  private final List<Machine> machines = new ArrayList<>();
  private final ArrayDeque<Beacon> air = new ArrayDeque<>();
  private long nowNs;

  /** Each machine sends a beacon to another robot; each of these and its answers reach some machines. */
  private void exchange(Rng rng, int steps) {
    for (int step = 0; step < steps; step++) {
      List<Machine> running = new ArrayList<>(machines);
      running.removeIf(machine -> machine.isStopped);
      Machine from = running.get(rng.nextInt(running.size()));
      RobotId to = NAMES.get(rng.nextInt(NAMES.size()));
      if (!to.equals(from.self)) {
        from.send(to, from.neighbours.echoTo(to), Answer.ACCEPTED);
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

  @Property(tries = 500)
  void itStopsNoRobotThatTheOthersAccept(@ForAll long seed) {
    machines.clear();
    air.clear();
    nowNs = 0;
    Rng rng = new Rng(seed);
    Machine bot0 = new Machine(0, 10, 3);
    Machine bot1 = new Machine(1, 11, 3);
    bot0.neighbours.remember(bot1.self, new Start(11, 2, new Nonce(2, 1)));
    bot1.neighbours.remember(bot0.self, new Start(10, 2, new Nonce(2, 2)));
    for (Machine each : List.of(bot0, bot1)) {
      each.neighbours.remember(NAMES.get(2), new Start(12, 2, new Nonce(2, 3)));
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
}
