package org.starl.robot.realtime;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.jetbrains.lincheck.Lincheck;
import org.jetbrains.lincheck.LincheckAssertionError;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.platform.StrandClosed;

/**
 * The strand's code under a scheduler that chooses the order of its threads' steps (Lincheck): random
 * orders, the same in each run of the test. A thread that waits for ever is a failure.
 */
@Tag("long")
class RealStrandOrdersTest {

  private static final int ORDERS = 500;

  /** A strand whose time stands still, with pieces that notice each other. */
  private static final class Bench {
    // Lincheck switches threads only at objects that it sees shared, and not through a collection.
    private static Bench shared;

    private final List<Throwable> errors = new ArrayList<>();
    private final RealStrand strand = new RealStrand("bot0", () -> 0L, errors::add);
    private final CountDownLatch ended = new CountDownLatch(1);
    private int running;
    private int pieces;

    Bench() {
      shared = this;
    }

    void piece() {
      enter();
      pieces++;
      running--;
    }

    void enter() {
      shared.running++;
      if (running != 1) {
        throw new IllegalStateException("two pieces at the same time");
      }
    }

    /** The app waits for two pieces, then ends. */
    void app() {
      try {
        strand.awaitUntil(() -> pieces == 2, Long.MAX_VALUE);
        enter();
        running--;
      } finally {
        ended.countDown();
      }
    }

    Thread poster() {
      Thread thread = new Thread(() -> strand.post(this::piece));
      thread.start();
      return thread;
    }

    void requireNoError() {
      for (Throwable error : errors) {
        throw new IllegalStateException(error);
      }
    }
  }

  private static void join(Thread... threads) {
    try {
      for (Thread thread : threads) {
        thread.join();
      }
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  private static void await(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void noPieceIsForgottenAndNoTwoRunTogether() {
    Lincheck.runConcurrentTest(
        ORDERS,
        () -> {
          Bench bench = new Bench();
          bench.strand.start(bench::app);
          join(bench.poster(), bench.poster());
          await(bench.ended);
          bench.strand.post(bench.strand::close);
          bench.requireNoError();
        });
  }

  @Test
  void aClosedStrandUnwindsItsApp() {
    Lincheck.runConcurrentTest(
        ORDERS,
        () -> {
          Bench bench = new Bench();
          CountDownLatch begun = new CountDownLatch(1);
          boolean[] isUnwound = {false};
          bench.strand.start(() -> {
            begun.countDown();
            try {
              bench.app();
            } catch (StrandClosed e) {
              isUnwound[0] = true;
              throw e;
            }
          });
          await(begun);
          Thread closer = new Thread(() -> bench.strand.post(bench.strand::close));
          closer.start();
          join(bench.poster(), closer);
          await(bench.ended);
          bench.requireNoError();
          if (!isUnwound[0]) {
            throw new IllegalStateException("the app ended by itself");
          }
        });
  }

  @Test
  void theSchedulerFindsPiecesThatRunTogether() {
    LincheckAssertionError found =
        assertThrows(
            LincheckAssertionError.class,
            () ->
                Lincheck.runConcurrentTest(
                    ORDERS,
                    () -> {
                      Bench bench = new Bench();
                      CountDownLatch ran = new CountDownLatch(1);
                      bench.strand.post(() -> {
                        try {
                          bench.piece();
                        } finally {
                          ran.countDown();
                        }
                      });
                      bench.piece();
                      await(ran);
                      bench.strand.post(bench.strand::close);
                      bench.requireNoError();
                    }));
    assertThat(found).hasMessageContaining("two pieces at the same time");
  }
}
