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
 * A test that simulates, once for each of many seeds.
 *
 * <pre>{@code
 * @StarlTest(seeds = 200, faults = {"loss(0.3)", "crash(any,at=5s,restart=2s)"})
 * void everybodyArrives(Simulation.Builder simulation, Afterwards afterwards) {
 *   simulation.robots(4, Hello::new);
 *   afterwards.check(result -> assertThat(result.results()).hasSize(4));
 * }
 * }</pre>
 *
 * <p>The method fills the builder, which has its seed already; it may also take {@link RunChecks}, a
 * {@code long}, which is the seed, and whatever other extensions give. It is called anew for each
 * seed; {@code @BeforeEach} methods are not. The test fails if in some run a specification is
 * violated, an app throws, an app has not ended within {@link #atMost}, or a check fails. The failure
 * says how to run that seed alone: with the configuration parameter or system property {@code
 * starl.seed}.
 */
@Target({ElementType.METHOD, ElementType.ANNOTATION_TYPE})
@Retention(RetentionPolicy.RUNTIME)
@Documented
@Test
@ExtendWith(StarlExtension.class)
public @interface StarlTest {

  /** Number of runs, at least 1. */
  int seeds() default 100;

  /** The first run's seed; each next run has the next one. */
  long firstSeed() default 1;

  /** Faults of every run, each as text: {@code crash(bot2,at=12s,restart=5s)}. */
  String[] faults() default {};

  /** Faults drawn by seed from these, over before half of the run's time, at most 60 s. */
  Envelope chaos() default Envelope.NONE;

  /** Simulated time after which a run ends, if the method sets none: with its unit. */
  String atMost() default "1200s";
}
