package org.starl.cli.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.cli.Cli;

/** Runs that long campaigns found: each violated a specification, or stood still, once. */
@Tag("long")
class FoundRunsTest {

  @ParameterizedTest
  @ValueSource(
      strings = {
        // A car went on asking for the place that it had left.
        "intersection --seed 691",
        "intersection --seed 11855",
        // Its own ghost of a robot that was removed without a restart stood in the way.
        "intersection --seed 1093",
        // Each of two consented to the other.
        "intersection --seed 691 --set redraws=35479ms#111",
        // False alarms: a promise to a removed process, a list after the body has left.
        "intersection --seed 1351",
        "intersection --seed 4318",
        // Two restarted robots wanted where the other stood.
        "mutex --seed 31 --set redraws=39534ms#21",
        // The way ahead of a restarted robot was given to one that waited for its body.
        "mutex --seed 31 --set redraws=20841ms#1"
      })
  void areGoodNow(String run) {
    Cli cli = Cli.run(("run --chaos " + run).split(" "));
    assertThat(cli.status()).as("./starl run --chaos %s: %s", run, cli.out()).isZero();
  }
}
