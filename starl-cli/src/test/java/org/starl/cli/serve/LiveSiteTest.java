package org.starl.cli.serve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.starl.apps.Demos;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.cli.HelloWithATwist;
import org.starl.input.BadInput;
import org.starl.sim.kernel.CarrierKind;

/** The runs that browsers start. */
class LiveSiteTest {

  /** Planning may read long files: meanwhile other browsers look at the site, and start runs. */
  @Test
  void aRunIsPlannedWithoutTheSitesLock() {
    AtomicReference<LiveSite> site = new AtomicReference<>();
    Map<String, ?> wanted = Map.of("app", "twist", "seed", 7);
    HelloWithATwist demo =
        new HelloWithATwist("twist", "Looks at the site while it is planned.") {
          private int depth;

          @Override
          protected Plan twist(Plan plan, Request request) {
            LiveSite its = Objects.requireNonNull(site.get());
            assertThat(Thread.holdsLock(its)).isFalse();
            // Four runs may go on; those that are planned count.
            if (++depth < 4) {
              its.start(wanted);
            } else {
              assertThatThrownBy(() -> its.start(wanted))
                  .isInstanceOf(BadInput.class)
                  .hasMessageContaining("4 runs go on");
            }
            return plan;
          }
        };
    try (LiveSite made =
        new LiveSite(new Demos(List.of(demo)), Site.Home.PLAYGROUND, CarrierKind.PLATFORM)) {
      site.set(made);
      int number = made.start(wanted);
      assertThat(Objects.requireNonNull(made.run(number)).title()).isEqualTo("twist, seed 7");
    }
  }
}
