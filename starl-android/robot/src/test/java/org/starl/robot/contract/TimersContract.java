package org.starl.robot.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.starl.platform.Timer;
import org.starl.platform.Timers;

/** What every {@link Timers} does. */
public abstract class TimersContract {

  private static final long MS = 1_000_000;

  private final List<String> log = new CopyOnWriteArrayList<>();
  private final CountDownLatch done = new CountDownLatch(1);
  private Ground ground;

  protected abstract Ground newGround();

  @BeforeEach
  void begin() {
    ground = newGround();
  }

  @AfterEach
  void end() {
    ground.close();
    assertThat(ground.errors()).isEmpty();
  }

  @Test
  void timersExpireOnTheStrandInTimeOrder() {
    onStrand(() -> {
      long startNs = now();
      for (int i : new int[] {3, 1, 4, 2, 0}) {
        timer("timer " + i).set(startNs + (5 + i) * MS);
      }
      timer(done).set(startNs + 15 * MS);
    });
    assertThat(log).containsExactly("timer 0", "timer 1", "timer 2", "timer 3", "timer 4");
  }

  @Test
  void timersOfEqualTimeExpireInTheOrderInWhichTheyWereSet() {
    onStrand(() -> {
      long atNs = now() + 5 * MS;
      List<Timer> timers = new ArrayList<>();
      for (int i = 0; i < 20; i++) {
        timers.add(timer("timer " + i));
      }
      for (int i = 19; i >= 0; i--) {
        timers.get(i).set(atNs);
      }
      timer(done).set(atNs);
    });
    assertThat(log).hasSize(20).startsWith("timer 19", "timer 18").endsWith("timer 1", "timer 0");
  }

  @Test
  void aTimerExpiresOnceAndNotEarly() {
    List<Long> lateNs = new CopyOnWriteArrayList<>();
    onStrand(() -> {
      long atNs = now() + 3 * MS;
      Timer timer = ground.timers().timer(() -> lateNs.add(now() - atNs));
      timer.set(atNs);
      timer(done).set(atNs + 10 * MS);
    });
    assertThat(lateNs).hasSize(1).allMatch(late -> late >= 0);
  }

  @Test
  void aTimerSetAgainExpiresAtItsLastTimeOnly() {
    onStrand(() -> {
      Timer timer = timer("expired");
      timer.set(now() + 20 * MS);
      timer.set(now() + 2 * MS);
      timer.set(now() + 5 * MS);
      timer(done).set(now() + 30 * MS);
    });
    assertThat(log).containsExactly("expired");
  }

  @Test
  void aTimerSetAgainForItsTimeKeepsItsPlace() {
    onStrand(() -> {
      long atNs = now() + 5 * MS;
      Timer first = timer("first");
      first.set(atNs);
      timer("second").set(atNs);
      first.set(atNs);
      timer(done).set(atNs);
    });
    assertThat(log).containsExactly("first", "second");
  }

  @Test
  void aTimerSetToNeverIsCancelled() {
    onStrand(() -> {
      Timer timer = timer("expired");
      timer.set(now() + 2 * MS);
      timer.set(Timer.NEVER);
      assertThat(timer.isSet()).isFalse();
      timer(done).set(now() + 5 * MS);
    });
    assertThat(log).isEmpty();
  }

  @Test
  void aCancelledTimerDoesNotExpireEvenIfItWasDue() {
    onStrand(() -> {
      Timer due = timer("due");
      Timer later = timer("later");
      due.set(now() - MS);
      later.set(now() + MS);
      assertThat(due.isSet()).isTrue();
      assertThat(log).isEmpty();
      due.cancel();
      later.cancel();
      assertThat(due.isSet()).isFalse();
      timer(done).set(now() + 10 * MS);
    });
    assertThat(log).isEmpty();
  }

  @Test
  void aDueTimerExpiresAfterEarlierPosts() {
    onStrand(() -> {
      ground.strand().post(() -> log.add("posted"));
      timer("expired").set(now() - 10 * MS);
      ground.strand().post(() -> log.add("posted later"));
      timer(done).set(now() + 5 * MS);
    });
    assertThat(log).containsExactly("posted", "expired", "posted later");
  }

  @Test
  void aTimerIsPendingFromItsSettingToItsExpiry() {
    onStrand(() -> {
      Timer[] timer = new Timer[1];
      timer[0] =
          ground
              .timers()
              .timer(() -> {
                log.add("set inside " + timer[0].isSet());
                if (log.size() < 3) {
                  timer[0].set(now() + MS);
                  assertThat(timer[0].isSet()).isTrue();
                } else {
                  done.countDown();
                }
              });
      assertThat(timer[0].isSet()).isFalse();
      timer[0].cancel();
      timer[0].set(now());
      assertThat(timer[0].isSet()).isTrue();
    });
    assertThat(log).hasSize(3).containsOnly("set inside false");
  }

  @Test
  void anAppAwaitsATimersEffect() {
    int[] expiries = {0};
    ground
        .strand()
        .start(() -> {
          Timer timer = ground.timers().timer(() -> expiries[0]++);
          timer.set(now() + 2 * MS);
          log.add("held " + ground.strand().awaitUntil(() -> expiries[0] > 0, Long.MAX_VALUE));
          done.countDown();
        });
    ground.runUntil(done);
    assertThat(log).containsExactly("held true");
  }

  @Test
  void aTimerOfAClosedStrandNeverExpires() {
    Timer[] timer = new Timer[1];
    onStrand(() -> {
      timer[0] = timer("too late");
      timer[0].set(now() + MS);
      ground.closeStrand();
      done.countDown();
    });
    assertThat(timer[0].isSet()).isFalse();
    timer[0].set(now());
    timer[0].cancel();
    assertThat(timer[0].isSet()).isFalse();
    ground.close();
    assertThat(log).isEmpty();
  }

  private void onStrand(Runnable piece) {
    ground.strand().post(piece);
    ground.runUntil(done);
  }

  private Timer timer(String says) {
    return ground
        .timers()
        .timer(() -> {
          assertThat(ground.strand().isCurrent()).isTrue();
          log.add(says);
        });
  }

  private Timer timer(CountDownLatch latch) {
    return ground.timers().timer(latch::countDown);
  }

  private long now() {
    return ground.clock().nowNs();
  }
}
