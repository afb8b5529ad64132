package org.starl.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

@Tag("long")
class FleetRatesTest {

  @Test
  void eachNumberOfRobotsHasARowOfEachDispatch() {
    List<Integer> calls = new ArrayList<>();
    List<Map<String, Object>> rows = FleetRates.take(2, 7, 1, calls::add);
    assertThat(calls).containsExactly(1, 2, 3, 4, 5).hasSize(FleetRates.rows(2));
    assertThat(rows)
        .extracting(row -> row.get("robots") + " " + row.get("dispatch") + " " + row.get("faults"))
        .containsExactly(
            "2 central none",
            "2 fleet none",
            "2 fleet loss 0.1",
            "2 fleet loss 0.3",
            "2 fleet a crash a minute");
    assertThat(rows)
        .allSatisfy(row -> assertThat((double) row.get("deliveries_an_hour")).isPositive());
    assertThat(FleetRates.rows(64)).isEqualTo(30);
    assertThat(FleetRates.rows(50)).as("2, 4, 8, 16, 32, 50").isEqualTo(30);
  }
}
