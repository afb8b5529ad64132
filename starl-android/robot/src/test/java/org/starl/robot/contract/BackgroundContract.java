package org.starl.robot.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.starl.platform.Background;

/** What every {@link Background} does. */
public abstract class BackgroundContract {

  private final List<String> log = new CopyOnWriteArrayList<>();
  private final CountDownLatch done = new CountDownLatch(1);
  private Ground ground;
  private Background background;

  protected abstract Ground newGround();

  protected abstract Background newBackground(Ground on);

  @BeforeEach
  void begin() {
    ground = newGround();
    background = newBackground(ground);
  }

  @AfterEach
  void end() {
    ground.close();
  }

  @Test
  void theTaskRunsOffTheStrandAndItsListenerOnIt() {
    ground
        .strand()
        .post(() ->
            background.submit(
                () -> log.add("task on strand: " + onStrand()),
                () -> {
                  log.add("done on strand: " + onStrand());
                  done.countDown();
                }));
    ground.runUntil(done);
    assertThat(log).containsExactly("task on strand: false", "done on strand: true");
  }

  @Test
  void theResultNeverComesInsideTheCall() {
    AtomicBoolean inside = new AtomicBoolean();
    ground
        .strand()
        .post(() -> {
          inside.set(true);
          background.submit(
              () -> {},
              () -> {
                log.add("inside: " + inside.get());
                done.countDown();
              });
          inside.set(false);
        });
    ground.runUntil(done);
    assertThat(log).containsExactly("inside: false");
  }

  @Test
  void tasksRunInSubmissionOrderAndTheirWritesAreVisible() {
    List<Integer> written = new ArrayList<>();
    ground
        .strand()
        .post(() -> {
          for (int i = 0; i < 20; i++) {
            int number = i;
            background.submit(
                () -> written.add(number), () -> log.add(number + " of " + written.get(number)));
          }
          background.submit(() -> {}, done::countDown);
        });
    ground.runUntil(done);
    assertThat(log).hasSize(20).startsWith("0 of 0", "1 of 1").endsWith("18 of 18", "19 of 19");
  }

  @Test
  void anAppAwaitsTheResult() {
    List<String> results = new ArrayList<>();
    ground
        .strand()
        .start(() -> {
          background.submit(() -> {}, () -> results.add("path"));
          boolean came = ground.strand().awaitUntil(() -> !results.isEmpty(), Long.MAX_VALUE);
          log.add(came + " " + results);
          done.countDown();
        });
    ground.runUntil(done);
    assertThat(log).containsExactly("true [path]");
  }

  @Test
  void anExceptionOfATaskIsThrownOnTheStrand() {
    IllegalStateException bug = new IllegalStateException("planted");
    ground
        .strand()
        .post(() -> {
          background.submit(
              () -> {
                throw bug;
              },
              () -> log.add("done"));
          background.submit(() -> {}, () -> log.add("after"));
        });
    ground.runUntilError();
    assertThat(ground.errors()).containsExactly(bug);
    assertThat(log).isEmpty();
  }

  private boolean onStrand() {
    return ground.strand().isCurrent();
  }
}
