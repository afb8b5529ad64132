package org.starl.sim.junit;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.starl.sim.fault.Envelope;

/**
 * A test that simulates many seeds.
 *
 * <pre>{@code
 * @StarlTest(seeds = 200, faults = {"loss(0.3)", "crash(any,at=5s,restart=2s)"})
 * void everyRobotArrives(Simulation.Builder simulation, RunChecks checks) {
 *   simulation.robots(4, Hello::new);
 *   checks.check(result -> assertThat(result.results()).hasSize(4));
 * }
 * }</pre>
 *
 * <p>The method configures the builder, whose seed is already set; it may also have parameters
 * {@link RunChecks}, {@code long} for the seed, {@link Cell}, and those of other extensions. It is called once
 * per seed; {@code @BeforeEach} methods are not. The test fails if in some run a specification is
 * violated, an app throws, an app has not ended within {@link #atMost}, or a check fails; or if no
 * run of 100 or more has checked a specification that applies. The
 * failure message tells how to repeat that seed: with the configuration parameter or system
 * property {@code starl.seed}. The first bad run is repeated, and its trace written to the folder
 * {@code target/starl}, or {@code build/starl} under Gradle, or that of {@code starl.artifacts};
 * with {@code starl-sim-view} on the class path there are pictures too, and {@code starl.view=true}
 * opens the viewer at the failure.
 */
@Target({ElementType.METHOD, ElementType.ANNOTATION_TYPE})
@Retention(RetentionPolicy.RUNTIME)
@Documented
@Test
@ExtendWith(StarlExtension.class)
public @interface StarlTest {

  /** Number of runs, at least 1. */
  int seeds() default 100;

  /** The seed of the first run; seeds of further runs are consecutive. */
  long firstSeed() default 1;

  /**
   * Values to combine, each as {@code key=value|value}: all seeds run for each combination, up to the
   * first one with a bad run. A key of
   * a setting ({@code messageLoss=0|0.3}) is set before the method is called; others are for the
   * method, which finds them in a parameter {@link Cell}.
   */
  String[] matrix() default {};

  /** Faults of every run, each as text: {@code crash(bot2,at=12s,restart=5s)}. */
  String[] faults() default {};

  /**
   * Number of schedules to explore for each seed after all runs went well: orders of its events
   * that the seed does not draw, with datagrams that take up to 800 ms ({@code starl explore} with
   * the strategy pct). The failure message names the changes as faults. None by default.
   */
  int explore() default 0;

  /** Faults drawn by seed from this envelope, ended by half of the run's time, at most 60 s. */
  Envelope chaos() default Envelope.NONE;

  /** Simulated time after which a run ends, unless the method sets an end: with its unit. */
  String atMost() default "1200s";
}
