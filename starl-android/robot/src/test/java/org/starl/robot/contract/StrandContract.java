// Longer than 500 lines because one contract in one class runs on every strand.
package org.starl.robot.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.starl.platform.Strand;
import org.starl.platform.StrandClosed;
import org.starl.platform.SuspendedApp;

/** What every {@link Strand} does. */
public abstract class StrandContract {

  private static final long MS = 1_000_000;

  /** A suspended app's continuation. */
  private static final String HERE = "here";

  private final List<String> log = new CopyOnWriteArrayList<>();
  private final CountDownLatch done = new CountDownLatch(1);
  private Ground ground;
  private Strand strand;

  protected abstract Ground newGround();

  @BeforeEach
  void begin() {
    ground = newGround();
    strand = ground.strand();
  }

  @AfterEach
  void end() {
    ground.close();
    assertThat(ground.errors()).isEmpty();
  }

  @Test
  void onlyTheAppAndPostsRunOnTheStrand() {
    assertThat(strand.isCurrent()).isFalse();
    List<Boolean> current = new CopyOnWriteArrayList<>();
    strand.start(() -> {
      current.add(strand.isCurrent());
      strand.awaitUntil(() -> current.add(strand.isCurrent()), Long.MAX_VALUE);
      strand.post(() -> current.add(strand.isCurrent()));
      strand.awaitUntil(() -> current.add(strand.isCurrent()) && current.size() > 4, now() + MS);
      done.countDown();
    });
    ground.runUntil(done);
    assertThat(current).hasSizeGreaterThan(4).containsOnly(true);
    assertThat(strand.isCurrent()).isFalse();
  }

  @Test
  void postsRunInOrderAndNeverInsideTheCall() {
    strand.post(() -> {
      for (int i = 0; i < 50; i++) {
        int number = i;
        strand.post(() -> log.add("posted " + number));
      }
      strand.post(done::countDown);
      log.add("posting is over");
    });
    ground.runUntil(done);
    assertThat(log).hasSize(51).startsWith("posting is over", "posted 0", "posted 1");
    assertThat(log).last().isEqualTo("posted 49");
  }

  @Test
  void codeBetweenTwoWaitsIsAtomic() {
    int[] shared = {0};
    List<Integer> torn = new ArrayList<>();
    Runnable increment =
        () -> {
          int before = shared[0];
          for (int i = 0; i < 1000; i++) {
            shared[0]++;
          }
          if (shared[0] != before + 1000) {
            torn.add(shared[0]);
          }
        };
    strand.start(() -> {
      for (int round = 0; round < 200; round++) {
        strand.post(increment);
        increment.run();
        strand.sleepUntil(now());
      }
      done.countDown();
    });
    ground.runUntil(done);
    assertThat(torn).isEmpty();
    assertThat(shared[0]).isEqualTo(400_000);
  }

  @Test
  void aSleepDoesNotEndEarly() {
    List<Long> lateNs = new CopyOnWriteArrayList<>();
    strand.start(() -> {
      for (int round = 0; round < 5; round++) {
        long atNs = now() + 2 * MS;
        strand.sleepUntil(atNs);
        lateNs.add(now() - atNs);
      }
      done.countDown();
    });
    ground.runUntil(done);
    assertThat(lateNs).hasSize(5).allMatch(late -> late >= 0);
  }

  @Test
  void aSleepUntilThePastRunsAllDuePieces() {
    strand.start(() -> {
      strand.post(() -> log.add("posted"));
      strand.sleepUntil(now() - MS);
      log.add("app");
      done.countDown();
    });
    ground.runUntil(done);
    assertThat(log).containsExactly("posted", "app");
  }

  @Test
  void anAppWhoseConditionBecomesTrueRunsNext() {
    int[] messages = {0};
    strand.start(() -> {
      strand.post(() -> {
        strand.post(() -> log.add("message " + ++messages[0]));
        strand.post(() -> log.add("message " + ++messages[0]));
        strand.post(() -> log.add("message " + ++messages[0]));
        strand.post(done::countDown);
      });
      boolean held = strand.awaitUntil(() -> messages[0] == 2, Long.MAX_VALUE);
      log.add("app " + held);
    });
    ground.runUntil(done);
    assertThat(log).containsExactly("message 1", "message 2", "app true", "message 3");
  }

  @Test
  void aConditionThatHoldsReturnsAtOnce() {
    strand.start(() -> {
      strand.post(() -> log.add("posted"));
      log.add("held " + strand.awaitUntil(() -> true, now() - MS));
      strand.post(done::countDown);
    });
    ground.runUntil(done);
    assertThat(log).containsExactly("held true", "posted");
  }

  @Test
  void anAwaitChecksItsConditionOnceMoreAtItsDeadline() {
    strand.start(() -> {
      long deadlineNs = now() + 2 * MS;
      log.add("held " + strand.awaitUntil(() -> false, deadlineNs));
      log.add("in time " + (now() < deadlineNs));
      long laterNs = now() + 2 * MS;
      log.add("held " + strand.awaitUntil(() -> now() >= laterNs, laterNs));
      done.countDown();
    });
    ground.runUntil(done);
    assertThat(log).containsExactly("held false", "in time false", "held true");
  }

  @Test
  void anUnusedDeadlineHasNoEffect() {
    int[] messages = {0};
    strand.start(() -> {
      strand.post(() -> messages[0]++);
      log.add("held " + strand.awaitUntil(() -> messages[0] == 1, now() + 2 * MS));
      strand.sleepUntil(now() + 10 * MS);
      log.add("held " + strand.awaitUntil(() -> messages[0] == 2, now() + 2 * MS));
      done.countDown();
    });
    ground.runUntil(done);
    assertThat(log).containsExactly("held true", "held false");
  }

  @Test
  void onlyTheAppMayWait() {
    strand.post(() ->
        assertThatThrownBy(() -> strand.sleepUntil(now()))
            .isInstanceOf(IllegalStateException.class)
            .hasMessageContaining("only the app may wait"));
    strand.start(() -> {
      strand.post(() ->
          assertThatThrownBy(() -> strand.awaitUntil(() -> true, now()))
              .isInstanceOf(IllegalStateException.class));
      strand.sleepUntil(now() + MS);
      done.countDown();
    });
    assertThatThrownBy(() -> strand.sleepUntil(now())).isInstanceOf(IllegalStateException.class);
    ground.runUntil(done);
  }

  @Test
  void theAppStartsOnce() {
    strand.start(done::countDown);
    assertThatThrownBy(() -> strand.start(() -> {})).isInstanceOf(IllegalStateException.class);
    ground.runUntil(done);
  }

  @Test
  void closingUnwindsTheAppAndStopsAllPieces() {
    strand.start(() -> {
      try {
        strand.post(done::countDown);
        strand.awaitUntil(() -> false, Long.MAX_VALUE);
      } catch (StrandClosed e) {
        log.add("told");
        throw e;
      } finally {
        strand.post(() -> log.add("too late"));
        log.add("finally");
      }
    });
    ground.runUntil(done);
    ground.closeStrand();
    strand.post(() -> log.add("too late"));
    ground.close();
    assertThat(log).containsExactly("told", "finally");
  }

  @Test
  void aPieceThatClosesItsStrandCompletesBeforeTheAppIsUnwound() {
    strand.start(() -> {
      try {
        strand.post(() -> {
          strand.post(() -> log.add("too late"));
          ground.closeStrand();
          log.add("piece is over");
        });
        strand.sleepUntil(now() + 3_600_000 * MS);
      } finally {
        log.add("finally");
        done.countDown();
      }
    });
    ground.runUntil(done);
    assertThat(log).containsExactly("piece is over", "finally");
  }

  @Test
  void anAppThatClosesItsStrandEndsAtItsNextWait() {
    strand.start(() -> {
      try {
        ground.closeStrand();
        log.add("goes on");
        strand.awaitUntil(() -> true, Long.MAX_VALUE);
        log.add("too late");
      } finally {
        done.countDown();
      }
    });
    ground.runUntil(done);
    assertThat(log).containsExactly("goes on");
  }

  @Test
  void anAppThatWaitsWhileItUnwindsIsInterruptedAgain() {
    strand.start(() -> {
      for (int i = 0; i < 3; i++) {
        try {
          strand.post(done::countDown);
          strand.sleepUntil(now() + 3_600_000 * MS);
        } catch (StrandClosed e) {
          log.add("told");
        }
      }
    });
    ground.runUntil(done);
    ground.closeStrand();
    ground.close();
    assertThat(log).containsExactly("told", "told", "told");
  }

  @Test
  void anAppThatDoesNotEndIsReported() {
    strand.start(() -> {
      while (true) {
        try {
          strand.post(done::countDown);
          strand.sleepUntil(now() + 3_600_000 * MS);
        } catch (StrandClosed e) {
          log.add("told");
        }
      }
    });
    ground.runUntil(done);
    ground.closeStrand();
    assertThat(takeError()).hasMessageContaining("does it catch StrandClosed?");
  }

  @Test
  void anExceptionOfTheAppIsReportedAndEndsTheStrand() {
    IllegalStateException bug = new IllegalStateException("bug");
    strand.start(() -> {
      strand.post(() -> log.add("too late"));
      done.countDown();
      throw bug;
    });
    ground.runUntil(done);
    ground.close();
    assertThat(takeError()).isSameAs(bug);
    assertThat(log).isEmpty();
  }

  @Test
  void anExceptionOfAPieceIsReportedAndUnwindsTheApp() {
    IllegalStateException bug = new IllegalStateException("bug");
    strand.start(() -> {
      try {
        strand.post(() -> {
          done.countDown();
          throw bug;
        });
        strand.sleepUntil(now() + 3_600_000 * MS);
      } finally {
        log.add("finally");
      }
    });
    ground.runUntil(done);
    ground.close();
    assertThat(takeError()).isSameAs(bug);
    assertThat(log).containsExactly("finally");
  }

  @Test
  void anAppThatSuspendsIsResumedInTheOrderOfOneThatBlocks() {
    int[] messages = {0};
    strand.start(
        new Suspending(
            held -> {
              strand.post(() -> log.add("posted"));
              return strand.suspendUntil(null, now() - MS, HERE);
            },
            held -> {
              log.add("slept " + held);
              strand.post(() -> {
                strand.post(() -> log.add("message " + ++messages[0]));
                strand.post(() -> log.add("message " + ++messages[0]));
                strand.post(() -> log.add("message " + ++messages[0]));
                strand.post(done::countDown);
              });
              return strand.suspendUntil(() -> messages[0] == 2, Long.MAX_VALUE, HERE);
            },
            held -> {
              log.add("app " + held + " " + strand.isCurrent());
              return false;
            }));
    ground.runUntil(done);
    assertThat(log)
        .containsExactly(
            "posted", "slept false", "message 1", "message 2", "app true true", "message 3");
  }

  @Test
  void aSuspendedAppChecksItsConditionAtOnceAndAtItsDeadline() {
    long[] deadlineNs = {0};
    strand.start(
        new Suspending(
            held -> strand.suspendUntil(() -> true, now() - MS, HERE),
            held -> {
              log.add("at once " + held);
              deadlineNs[0] = now() + 2 * MS;
              return strand.suspendUntil(() -> false, deadlineNs[0], HERE);
            },
            held -> {
              log.add("held " + held + ", in time " + (now() < deadlineNs[0]));
              deadlineNs[0] = now() + 2 * MS;
              return strand.suspendUntil(() -> now() >= deadlineNs[0], deadlineNs[0], HERE);
            },
            held -> {
              log.add("held " + held);
              done.countDown();
              return false;
            }));
    ground.runUntil(done);
    assertThat(log).containsExactly("at once true", "held false, in time false", "held true");
  }

  @Test
  void aSuspendedAppMayNotBlockAndAnotherMayNotSuspend() {
    strand.post(() ->
        assertThatThrownBy(() -> strand.suspendUntil(null, now(), HERE))
            .hasMessageContaining("only the app may wait"));
    strand.start(
        new Suspending(held -> {
          assertThatThrownBy(() -> strand.sleepUntil(now()))
              .isInstanceOf(IllegalStateException.class)
              .hasMessageContaining(": a blocking call in an app that suspends");
          assertThatThrownBy(() -> strand.awaitUntil(() -> false, now()))
              .hasMessageContaining("await(mutex.acquiring(");
          done.countDown();
          return false;
        }));
    assertThatThrownBy(() -> strand.start(() -> {})).isInstanceOf(IllegalStateException.class);
    ground.runUntil(done);
  }

  @Test
  void anAppThatBlocksMayNotSuspend() {
    strand.start(() -> {
      assertThatThrownBy(() -> strand.suspendUntil(null, now(), HERE))
          .hasMessageContaining("only an app without a thread may suspend");
      done.countDown();
    });
    ground.runUntil(done);
  }

  @Test
  void closingEndsASuspendedAppInItsWait() {
    strand.start(
        new Suspending(
            held -> {
              strand.post(done::countDown);
              return strand.suspendUntil(() -> false, Long.MAX_VALUE, HERE);
            },
            held -> {
              log.add("too late");
              return false;
            }));
    ground.runUntil(done);
    ground.closeStrand();
    ground.close();
    assertThat(log).containsExactly("told");
  }

  @Test
  void aSuspendedAppThatDoesNotEndIsReported() {
    strand.start(
        new SuspendedApp() {
          @Override
          public boolean resume(
              @Nullable Object continuation, boolean held, @Nullable StrandClosed closed) {
            if (closed != null) {
              log.add("told");
            }
            while (true) {
              try {
                strand.post(done::countDown);
                return strand.suspendUntil(null, now() + 3_600_000 * MS, HERE);
              } catch (StrandClosed e) {
                log.add("told");
              }
            }
          }

          @Override
          public StackTraceElement[] stack(Object continuation) {
            return new StackTraceElement[0];
          }
        });
    ground.runUntil(done);
    ground.closeStrand();
    assertThat(takeError()).hasMessageContaining("does it catch StrandClosed?");
    assertThat(log).hasSizeGreaterThan(2);
  }

  @Test
  void anExceptionOfASuspendedAppIsReportedAndEndsTheStrand() {
    IllegalStateException bug = new IllegalStateException("bug");
    strand.start(
        new Suspending(
            held -> strand.suspendUntil(null, now() + MS, HERE),
            held -> {
              strand.post(() -> log.add("too late"));
              done.countDown();
              throw bug;
            }));
    ground.runUntil(done);
    ground.close();
    assertThat(takeError()).isSameAs(bug);
    assertThat(log).isEmpty();
  }

  private interface Piece {
    /** Runs the app from a wait to the next; whether it goes on at once. */
    boolean goesOn(boolean held);
  }

  /** An app without a thread: code for its start and for the end of each of its waits. */
  private final class Suspending implements SuspendedApp {
    private final Deque<Piece> rest;
    private boolean isStarted;

    Suspending(Piece... pieces) {
      rest = new ArrayDeque<>(List.of(pieces));
    }

    @Override
    public boolean resume(
        @Nullable Object continuation, boolean held, @Nullable StrandClosed closed) {
      if (closed != null) {
        log.add("told");
        throw closed;
      }
      assertThat(continuation).isEqualTo(isStarted ? HERE : null);
      isStarted = true;
      boolean last = held;
      while (rest.remove().goesOn(last)) {
        last = true;
      }
      return rest.isEmpty();
    }

    @Override
    public StackTraceElement[] stack(Object continuation) {
      return new StackTraceElement[0];
    }
  }

  private Throwable takeError() {
    assertThat(ground.errors()).hasSize(1);
    return ground.errors().remove(0);
  }

  private long now() {
    return ground.clock().nowNs();
  }
}
