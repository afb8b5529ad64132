package org.starl.sim.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.starl.platform.StrandClosed;
import org.starl.platform.Timer;
import org.starl.random.Rng;

/** Random robots that sleep, await, post, set timers and die: the same log on both carriers. */
class CarriersAgreeTest {

  @Property(tries = 150)
  void bothCarriersGiveTheSameOrder(
      @ForAll long seed, @ForAll @IntRange(min = 1, max = 12) int robots) {
    List<String> onVirtual = new RandomRun(CarrierKind.VIRTUAL, seed, robots).log();
    List<String> onPlatform = new RandomRun(CarrierKind.PLATFORM, seed, robots).log();
    assertThat(onVirtual).isEqualTo(onPlatform);
  }

  @Property(tries = 20)
  void differentSeedsGiveDifferentLogs(@ForAll long seed) {
    List<String> one = new RandomRun(CarrierKind.VIRTUAL, seed, 6).log();
    List<String> other = new RandomRun(CarrierKind.VIRTUAL, seed + 1, 6).log();
    assertThat(one).isNotEqualTo(other);
  }

  private static final class RandomRun {

    private static final long END_NS = 20_000;

    private final List<String> log = new ArrayList<>();
    private final List<SimStrand> strands = new ArrayList<>();
    private final int[] inbox;
    private final Kernel kernel;

    RandomRun(CarrierKind kind, long seed, int robots) {
      kernel = new Kernel(kind);
      inbox = new int[robots];
      Rng rng = new Rng(seed);
      for (int i = 0; i < robots; i++) {
        strands.add(kernel.strand("robot" + i));
      }
      for (int i = 0; i < robots; i++) {
        int self = i;
        Rng own = rng.fork("robot" + i);
        strands.get(i).start(() -> app(self, own));
        if (own.nextBoolean(0.3)) {
          kernel.schedule(own.nextLong(0, END_NS), strands.get(i)::close);
        }
      }
    }

    List<String> log() {
      kernel.run(END_NS, () -> false);
      kernel.close();
      log.add(kernel.events() + " events until " + kernel.nowNs());
      return log;
    }

    private void app(int self, Rng rng) {
      SimStrand strand = strands.get(self);
      Timer timer = strand.timer(() -> say(self, "timer"));
      try {
        while (true) {
          switch (rng.nextInt(6)) {
            case 0 -> strand.sleepUntil(kernel.nowNs() + rng.nextInt(4) * 100L);
            case 1 -> {
              int before = inbox[self];
              long deadlineNs = kernel.nowNs() + rng.nextInt(1000);
              boolean met = strand.awaitUntil(() -> inbox[self] > before, deadlineNs);
              say(self, "awaited " + met);
            }
            case 2 -> strand.post(() -> say(self, "posted"));
            case 3 -> timer.set(kernel.nowNs() + rng.nextInt(500));
            case 4 -> timer.cancel();
            default -> send(self, rng);
          }
        }
      } catch (StrandClosed e) {
        say(self, "closed");
        throw e;
      } finally {
        say(self, "finally");
      }
    }

    private void send(int self, Rng rng) {
      int to = rng.nextInt(strands.size());
      Runnable delivery =
          () -> {
            inbox[to]++;
            say(to, "message " + inbox[to] + " from " + self);
            if (rng.nextBoolean(0.2)) {
              strands.get(self).post(() -> say(self, "heard of it"));
            }
            if (rng.nextBoolean(0.01)) {
              strands.get(rng.nextInt(strands.size())).close();
            }
          };
      kernel.schedule(kernel.nowNs() + rng.nextInt(300), strands.get(to), delivery);
      strands.get(self).sleepUntil(kernel.nowNs() + rng.nextInt(50));
    }

    private void say(int robot, String what) {
      assertThat(strands.get(robot).isCurrent()).isTrue();
      log.add(kernel.nowNs() + " robot" + robot + " " + what);
    }
  }
}
