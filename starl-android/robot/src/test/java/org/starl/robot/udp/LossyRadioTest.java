package org.starl.robot.udp;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.platform.Radio;
import org.starl.platform.Timer;
import org.starl.random.Rng;
import org.starl.robot.contract.Ground;
import org.starl.robot.contract.RadioContract;

/** A radio in bad air keeps a radio's contract; and the air is as bad as it was told to be. */
class LossyRadioTest extends RadioContract {

  private static final RobotId A = new RobotId("a");
  private static final RobotId B = new RobotId("b");
  private static final RobotId C = new RobotId("c");

  /** UDP, where a fifth of all copies is lost and the others are late. */
  private static final class BadAir implements Air {
    private final UdpAir air = new UdpAir();
    private final List<Radio> radios = new ArrayList<>();

    BadAir() {
      List<RobotId> robots = new ArrayList<>();
      for (int robot = 0; robot < ROBOTS; robot++) {
        robots.add(new RobotId("robot" + robot));
      }
      for (int robot = 0; robot < ROBOTS; robot++) {
        Ground ground = air.ground(robot);
        radios.add(
            new LossyRadio(
                air.radio(robot),
                robots.get(robot),
                robots,
                ground.clock(),
                ground.timers(),
                new Rng(robot),
                rng -> rng.nextBoolean(0.2) ? LossyRadio.LOST : rng.nextLong(0, 2_000_000)));
      }
    }

    @Override
    public Ground ground(int robot) {
      return air.ground(robot);
    }

    @Override
    public Radio radio(int robot) {
      return radios.get(robot);
    }

    @Override
    public void closeRadio(int robot) {
      air.closeRadio(robot);
    }

    @Override
    public void close() {
      air.close();
    }
  }

  @Override
  protected RadioContract.Air newAir() {
    return new BadAir();
  }

  /** Collects what leaves, and runs timers when it is told to. */
  private static final class Bench implements Radio {
    private final List<String> left = new ArrayList<>();
    private final List<Runnable> due = new ArrayList<>();
    private final List<Long> timesNs = new ArrayList<>();

    LossyRadio radio(long seed, LossyRadio.Air air) {
      return new LossyRadio(this, A, List.of(A, B, C), () -> 5, this::timer, new Rng(seed), air);
    }

    private Timer timer(Runnable action) {
      return new Timer() {
        @Override
        public void set(long atNs) {
          due.add(action);
          timesNs.add(atNs);
        }

        @Override
        public void cancel() {
          throw new IllegalStateException("what was sent is sent");
        }

        @Override
        public boolean isSet() {
          return true;
        }
      };
    }

    @Override
    public void send(RobotId to, byte[] buffer, int length) {
      left.add(to + ":" + buffer[0]);
    }

    @Override
    public void broadcast(byte[] buffer, int length) {
      throw new IllegalStateException("expected a copy for each");
    }

    @Override
    public void onReceive(Receiver receiver) {
      throw new IllegalStateException("nobody asks");
    }
  }

  @Test
  void copiesAreSentAfterTheCallWithTheConfiguredDelay() {
    Bench bench = new Bench();
    LossyRadio radio = bench.radio(1, rng -> 100);
    byte[] buffer = {7};
    radio.broadcast(buffer, 1);
    buffer[0] = 8;
    assertThat(bench.left).isEmpty();
    bench.due.forEach(Runnable::run);
    assertThat(bench.left).containsExactly("b:7", "c:7");
    assertThat(bench.timesNs).containsOnly(105L);
    assertThat(List.of(radio.copies(), radio.lost())).containsExactly(2L, 0L);
  }

  @Test
  void eachLinkHasItsOwnRandomGenerator() {
    Bench bench = new Bench();
    LossyRadio radio = bench.radio(1, rng -> rng.nextBoolean(0.2) ? LossyRadio.LOST : 0);
    Bench alone = new Bench();
    LossyRadio same = alone.radio(1, rng -> rng.nextBoolean(0.2) ? LossyRadio.LOST : 0);
    for (byte i = 0; i < 100; i++) {
      radio.broadcast(new byte[] {i}, 1);
      same.send(C, new byte[] {i}, 1);
    }
    bench.due.forEach(Runnable::run);
    alone.due.forEach(Runnable::run);
    List<String> toC = bench.left.stream().filter(copy -> copy.startsWith("c")).toList();
    List<String> toB = bench.left.stream().filter(copy -> copy.startsWith("b")).toList();
    assertThat(alone.left).isEqualTo(toC);
    assertThat(toB).isNotEqualTo(toC.stream().map(copy -> copy.replace('c', 'b')).toList());
    assertThat(radio.lost()).isBetween(20L, 60L).isEqualTo(200 - bench.left.size());
  }
}
