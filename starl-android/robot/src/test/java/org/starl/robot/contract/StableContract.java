package org.starl.robot.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.starl.platform.StableStorage;

/** What every {@link StableStorage} does. */
public abstract class StableContract {

  private final List<String> log = new CopyOnWriteArrayList<>();
  private Ground ground;
  private StableStorage stable;

  protected abstract Ground newGround();

  /** The storage, empty, on the strand of {@code ground}. */
  protected abstract StableStorage open(Ground ground);

  /** The same storage after a crash of the robot's program, for its next incarnation. */
  protected abstract StableStorage crashAndReopen(Ground ground);

  @BeforeEach
  void begin() {
    ground = newGround();
    stable = open(ground);
  }

  @AfterEach
  void end() {
    ground.close();
    assertThat(ground.errors()).isEmpty();
  }

  @Test
  void anUnknownKeyIsNull() {
    onStrand(() -> assertThat(stable.get("nothing")).isNull());
  }

  @Test
  void aWrittenValueIsReadAtOnce() {
    onStrand(() -> {
      stable.put("a", new byte[] {1, 2}, () -> {});
      stable.put("b", new byte[0], () -> {});
      stable.put("a", new byte[] {3}, () -> {});
      assertThat(stable.get("a")).containsExactly(3);
      assertThat(stable.get("b")).isEmpty();
      stable.remove("a");
      assertThat(stable.get("a")).isNull();
    });
  }

  @Test
  void valuesAreCopied() {
    onStrand(() -> {
      byte[] value = {1};
      stable.put("a", value, () -> {});
      value[0] = 2;
      byte[] read = stable.get("a");
      assertThat(read).containsExactly(1);
      read[0] = 3;
      assertThat(stable.get("a")).containsExactly(1);
    });
  }

  @Test
  void flushesAreReportedOnTheStrandInOrderAndNeverInsideTheCall() {
    CountDownLatch done = new CountDownLatch(20);
    onStrand(() -> {
      for (int i = 0; i < 20; i++) {
        int number = i;
        stable.put("key" + i % 3, new byte[] {(byte) i}, () -> flushed(number, done));
        if (i % 5 == 0) {
          stable.remove("key1");
        }
      }
      log.add("putting is over");
    });
    ground.runUntil(done);
    List<String> expected = new ArrayList<>(List.of("putting is over"));
    for (int i = 0; i < 20; i++) {
      expected.add("flushed " + i);
    }
    assertThat(log).isEqualTo(expected);
  }

  @Test
  void flushedValuesSurviveACrash() {
    CountDownLatch done = new CountDownLatch(1);
    onStrand(() -> {
      stable.put("first", new byte[] {9}, () -> {});
      stable.put("Ünïcode / and ../dots", new byte[] {1, 2, 3}, () -> {});
      stable.put("gone", new byte[] {1}, () -> {});
      stable.remove("gone");
      stable.put("first", new byte[] {4}, done::countDown);
    });
    ground.runUntil(done);
    stable = crashAndReopen(ground);
    onStrand(() -> {
      assertThat(stable.get("first")).containsExactly(4);
      assertThat(stable.get("Ünïcode / and ../dots")).containsExactly(1, 2, 3);
      assertThat(stable.get("gone")).isNull();
    });
  }

  @Test
  void aCrashBetweenTwoWritesKeepsTheOlderOrTheNewerValue() {
    CountDownLatch done = new CountDownLatch(1);
    onStrand(() -> stable.put("a", new byte[] {1, 1}, done::countDown));
    ground.runUntil(done);
    onStrand(() -> stable.put("a", new byte[] {2, 2}, () -> {}));
    stable = crashAndReopen(ground);
    onStrand(() -> assertThat(stable.get("a")).isIn(new byte[] {1, 1}, new byte[] {2, 2}));
  }

  private void flushed(int number, CountDownLatch done) {
    assertThat(ground.strand().isCurrent()).isTrue();
    log.add("flushed " + number);
    done.countDown();
  }

  private void onStrand(Runnable piece) {
    CountDownLatch done = new CountDownLatch(1);
    AtomicReference<Throwable> failure = new AtomicReference<>();
    ground
        .strand()
        .post(() -> {
          try {
            piece.run();
          } catch (Throwable e) {
            failure.set(e);
          } finally {
            done.countDown();
          }
        });
    ground.runUntil(done);
    assertThat(failure.get()).isNull();
  }
}
