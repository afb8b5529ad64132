package org.starl.robot.realtime;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.platform.Clock;
import org.starl.platform.Timer;

/** What only real time has: several threads, and pieces that take their time. */
@Tag("realtime")
class RealStrandTest {

  private final List<Throwable> errors = new CopyOnWriteArrayList<>();

  @Test
  void piecesFromManyThreadsNeverOverlap() throws Exception {
    int threads = 8;
    int posts = 2000;
    int[] counter = {0};
    CountDownLatch done = new CountDownLatch(threads * posts);
    try (RealStrand strand = new RealStrand("robot0", new RealClock(), errors::add)) {
      for (int i = 0; i < threads; i++) {
        Runnable poster =
            () -> {
              for (int post = 0; post < posts; post++) {
                strand.post(() -> {
                  counter[0]++;
                  done.countDown();
                });
              }
            };
        new Thread(poster).start();
      }
      assertThat(done.await(60, TimeUnit.SECONDS)).isTrue();
      assertThat(counter[0]).isEqualTo(threads * posts);
      assertThat(strand.use().pieces()).isGreaterThanOrEqualTo(threads * posts - 1);
    }
    assertThat(errors).isEmpty();
  }

  @Test
  void theStrandReportsTheDurationOfItsPieces() throws Exception {
    SteppedClock clock = new SteppedClock();
    CountDownLatch done = new CountDownLatch(1);
    RealStrand strand = new RealStrand("robot0", clock, errors::add);
    strand.post(() -> clock.nowNs += 300);
    strand.post(() ->
        strand.start(() -> {
          clock.nowNs += 500;
          strand.sleepUntil(0);
          clock.nowNs += 20;
          strand.post(done::countDown);
        }));
    assertThat(done.await(60, TimeUnit.SECONDS)).isTrue();
    strand.close();
    assertThat(strand.use()).isEqualTo(new StrandUse(5, 820, 23, 500, 500, "the app"));
    assertThat(errors).isEmpty();
  }

  @Test
  void aPieceOverTheLimitIsReportedAndThenOnlyOneTwiceAsLong() throws Exception {
    SteppedClock clock = new SteppedClock();
    CountDownLatch done = new CountDownLatch(1);
    List<String> told = new CopyOnWriteArrayList<>();
    RealStrand strand = new RealStrand("robot0", clock, errors::add);
    strand.onLongPiece(200, (ns, by) -> told.add(ns + " by " + by));
    for (long ns : new long[] {150, 300, 500, 700}) {
      strand.post(() -> clock.nowNs += ns);
    }
    strand.post(done::countDown);
    assertThat(done.await(60, TimeUnit.SECONDS)).isTrue();
    strand.close();
    assertThat(told)
        .containsExactly("300 by a message or an event", "700 by a message or an event");
  }

  @Test
  void timersThatAPieceSetsTooLateExpireInTheOrderOfTheirTimes() throws Exception {
    SteppedClock clock = new SteppedClock();
    CountDownLatch done = new CountDownLatch(1);
    List<Integer> expired = new CopyOnWriteArrayList<>();
    RealStrand strand = new RealStrand("robot0", clock, errors::add);
    strand.post(() -> {
      clock.nowNs += 100;
      for (int atNs : new int[] {30, 10, 20}) {
        strand.timer(() -> expired.add(atNs)).set(atNs);
      }
      strand.timer(done::countDown).set(100);
    });
    assertThat(done.await(60, TimeUnit.SECONDS)).isTrue();
    strand.close();
    assertThat(expired).containsExactly(10, 20, 30);
    assertThat(errors).isEmpty();
  }

  @Test
  void durationsOfPiecesAreReportedWithin25Percent() {
    StrandTally tally = new StrandTally();
    for (int i = 1; i <= 1000; i++) {
      tally.add(i * 1000L, i == 1000 ? "a timer" : "the app");
    }

    StrandUse use = tally.use();

    assertThat(use.medianNs()).isBetween(500_000L, 625_000L);
    assertThat(use.p99Ns()).isBetween(990_000L, 1_000_000L);
    assertThat(use.longestPieceNs()).isEqualTo(1_000_000);
    assertThat(use.longestBy()).isEqualTo("a timer");
  }

  /** The plan needs what only the steps give: on the strand it would wait for ever. */
  @Test
  void motionContinuesWhileAPlanIsComputedOffTheStrand() throws Exception {
    CountDownLatch steps = new CountDownLatch(5);
    CountDownLatch planned = new CountDownLatch(1);
    RealClock clock = new RealClock();
    try (RealStrand strand = new RealStrand("robot0", clock, errors::add);
        RealBackground background = new RealBackground("robot0", strand)) {
      Timer[] step = new Timer[1];
      step[0] =
          strand.timer(() -> {
            steps.countDown();
            step[0].set(clock.nowNs() + 1_000_000);
          });
      strand.post(() -> {
        background.submit(
            () -> {
              if (!await(steps)) {
                throw new IllegalStateException("no step while the plan was computed");
              }
            },
            planned::countDown);
        step[0].set(clock.nowNs());
      });
      assertThat(planned.await(60, TimeUnit.SECONDS)).isTrue();
    }
    assertThat(errors).isEmpty();
  }

  private static boolean await(CountDownLatch latch) {
    try {
      return latch.await(30, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  @Test
  void noThreadOutlivesItsStrand() throws Exception {
    List<Thread> threads = new CopyOnWriteArrayList<>();
    CountDownLatch done = new CountDownLatch(2);
    RealStrand strand = new RealStrand("robot0", new RealClock(), errors::add);
    Runnable noteThread =
        () -> {
          threads.add(Thread.currentThread());
          done.countDown();
        };
    strand.post(noteThread);
    strand.start(() -> {
      noteThread.run();
      strand.awaitUntil(() -> false, Long.MAX_VALUE);
    });
    assertThat(done.await(60, TimeUnit.SECONDS)).isTrue();
    assertThat(threads).hasSize(2).doesNotHaveDuplicates();
    strand.close();
    strand.close();
    for (Thread thread : threads) {
      thread.join(60_000);
      assertThat(thread.isAlive()).isFalse();
    }
    assertThat(strand.isClosed()).isTrue();
  }

  @Test
  void theClockNeverRunsBackwards() {
    RealClock clock = new RealClock();
    long before = clock.nowNs();
    assertThat(before).isNotNegative();
    for (int i = 0; i < 10_000; i++) {
      long now = clock.nowNs();
      assertThat(now).isGreaterThanOrEqualTo(before);
      before = now;
    }
  }

  /** Stands still unless a piece moves it. */
  private static final class SteppedClock implements Clock {
    private volatile long nowNs;

    @Override
    public long nowNs() {
      return nowNs;
    }
  }
}
