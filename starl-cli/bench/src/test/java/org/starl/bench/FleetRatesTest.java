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
    List<Map<String, Object>> rows = FleetRates.take(3, 7, 1, calls::add);
    assertThat(calls).containsExactly(1, 2, 3, 4).hasSize(FleetRates.rows(3));
    assertThat(rows)
        .extracting(
            row -> row.get("robots") + " " + row.get("dispatch") + " " + row.get("message_loss"))
        .containsExactly("2 central 0.0", "2 fleet 0.0", "2 fleet 0.1", "2 fleet 0.3");
    assertThat(rows)
        .allSatisfy(row -> assertThat((double) row.get("deliveries_an_hour")).isPositive());
    assertThat(FleetRates.rows(64)).isEqualTo(24);
  }
}
