package org.starl.robot.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.SortedMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Angles;
import org.starl.geometry.Fix;
import org.starl.platform.Positioning;

/** What every {@link Positioning} does, for robots that drive along x. */
public abstract class PositioningContract {

  private static final int FIXES = 20;

  /** Longer than a fix's time can be wrong, on a machine that is busy. */
  private static final long SLACK_NS = 200_000_000;

  private Course course;

  /**
   * Robots {@code robot0} and {@code robot1}, which face x and drive: at time t of the ground's clock
   * they are where {@link #xMm} says, and at y = 1000 times their number.
   */
  public interface Course extends AutoCloseable {

    double MM_PER_S = 200;

    Ground ground();

    Positioning positioning(int robot);

    /** The newest fixes of all robots, by name. From any thread. */
    SortedMap<String, Fix> newest();

    /** Whether the measuring system sees the robot, from now on. From any thread. */
    void see(int robot, boolean isSeen);

    static double xMm(long atNs) {
      return MM_PER_S * atNs / 1e9;
    }

    @Override
    void close();
  }

  protected abstract Course newCourse();

  @BeforeEach
  void begin() {
    course = newCourse();
  }

  @AfterEach
  void end() {
    course.close();
    assertThat(course.ground().errors()).isEmpty();
  }

  @Test
  void fixesArriveOnTheStrandWithTheRobotsPoseAtTheirTime() {
    List<Fix> fixes = new CopyOnWriteArrayList<>();
    List<Long> cameNs = new CopyOnWriteArrayList<>();
    CountDownLatch done = new CountDownLatch(FIXES);
    Ground ground = course.ground();
    follow(
        1,
        fix -> {
          assertThat(ground.strand().isCurrent()).isTrue();
          cameNs.add(ground.clock().nowNs());
          fixes.add(fix);
          done.countDown();
        });
    ground.runUntil(done);
    for (int i = 0; i < FIXES; i++) {
      Fix fix = fixes.get(i);
      assertThat(fix.timeNs()).isLessThanOrEqualTo(cameNs.get(i));
      assertThat(Math.abs(fix.pose().xMm() - Course.xMm(fix.timeNs())))
          .isLessThanOrEqualTo(fix.errorMm() + 1e-6);
      assertThat(fix.pose().yMm()).isBetween(1000 - fix.errorMm(), 1000 + fix.errorMm());
      assertThat(Math.abs(Angles.difference(fix.pose().headingRad(), 0)))
          .isLessThanOrEqualTo(fix.errorRad());
      assertThat(i == 0 || fix.timeNs() > fixes.get(i - 1).timeNs()).isTrue();
    }
  }

  @Test
  void noFixArrivesInsideTheCallThatRegistersTheReceiver() {
    boolean[] isAsking = new boolean[1];
    CountDownLatch done = new CountDownLatch(1);
    Positioning positioning = course.positioning(0);
    onStrand(() -> {
      isAsking[0] = true;
      positioning.onFix(fix -> {
        assertThat(isAsking[0]).isFalse();
        done.countDown();
      });
      isAsking[0] = false;
    });
    course.ground().runUntil(done);
  }

  @Test
  void aSecondReceiverOfFixesIsRefused() {
    Positioning positioning = course.positioning(0);
    onStrand(() -> {
      positioning.onFix(fix -> {});
      assertThatThrownBy(() -> positioning.onFix(fix -> {}))
          .isInstanceOf(IllegalStateException.class)
          .hasMessageContaining("receiver");
    });
  }

  @Test
  void theNewestFixesOfAllRobotsAreVisible() {
    CountDownLatch done = new CountDownLatch(2);
    CountDownLatch first = new CountDownLatch(FIXES);
    follow(0, fix -> first.countDown());
    follow(1, fix -> done.countDown());
    course.ground().runUntil(first);
    course.ground().runUntil(done);
    SortedMap<String, Fix> newest = course.newest();
    assertThat(newest.keySet()).contains("robot0", "robot1");
    for (int i = 0; i < 2; i++) {
      Fix fix = newest.get("robot" + i);
      assertThat(Math.abs(fix.pose().xMm() - Course.xMm(fix.timeNs())))
          .isLessThanOrEqualTo(fix.errorMm() + 1e-6);
      assertThat(Math.abs(fix.pose().yMm() - 1000 * i)).isLessThanOrEqualTo(fix.errorMm());
    }
  }

  @Test
  void eachRobotHasItsOwnFixes() {
    List<Fix> first = new CopyOnWriteArrayList<>();
    List<Fix> second = new CopyOnWriteArrayList<>();
    CountDownLatch done = new CountDownLatch(2 * FIXES);
    follow(
        0,
        fix -> {
          first.add(fix);
          done.countDown();
        });
    follow(
        1,
        fix -> {
          second.add(fix);
          done.countDown();
        });
    course.ground().runUntil(done);
    assertThat(first).allMatch(fix -> Math.abs(fix.pose().yMm()) <= fix.errorMm());
    assertThat(second).allMatch(fix -> Math.abs(fix.pose().yMm() - 1000) <= fix.errorMm());
  }

  @Test
  void fixesResumeWhenTheRobotIsVisibleAgain() {
    List<Long> lostNs = new CopyOnWriteArrayList<>();
    List<Long> found = new CopyOnWriteArrayList<>();
    CountDownLatch seen = new CountDownLatch(1);
    CountDownLatch unseen = new CountDownLatch(1);
    CountDownLatch seenAgain = new CountDownLatch(1);
    Ground ground = course.ground();
    follow(
        0,
        fix -> {
          found.add(fix.timeNs());
          seen.countDown();
          if (unseen.getCount() == 0) {
            seenAgain.countDown();
          }
        });
    ground.runUntil(seen);
    onStrand(() -> {
      course.see(0, false);
      lostNs.add(ground.clock().nowNs());
    });
    // The other robot's fixes show that the system still measures.
    follow(
        1,
        fix -> {
          if (fix.timeNs() > lostNs.get(0) + 3 * SLACK_NS) {
            unseen.countDown();
          }
        });
    ground.runUntil(unseen);
    assertThat(found).allMatch(atNs -> atNs <= lostNs.get(0) + SLACK_NS);
    onStrand(() -> course.see(0, true));
    ground.runUntil(seenAgain);
    assertThat(found.get(found.size() - 1)).isGreaterThan(lostNs.get(0) + 2 * SLACK_NS);
  }

  private void follow(int robot, Positioning.Receiver receiver) {
    Positioning positioning = course.positioning(robot);
    onStrand(() -> positioning.onFix(receiver));
  }

  private void onStrand(Runnable piece) {
    CountDownLatch done = new CountDownLatch(1);
    Ground ground = course.ground();
    ground
        .strand()
        .post(() -> {
          piece.run();
          done.countDown();
        });
    ground.runUntil(done);
  }
}
