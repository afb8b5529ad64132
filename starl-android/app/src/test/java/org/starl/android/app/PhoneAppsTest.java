package org.starl.android.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalInt;
import java.util.SortedMap;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.annotation.Config;
import org.starl.android.app.RobotService.Phase;
import org.starl.apps.Demo;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.intersection.IntersectionDemo;
import org.starl.apps.lightpaint.LightPaintDemo;
import org.starl.apps.maze.MazeDemo;
import org.starl.apps.race.RaceDemo;
import org.starl.apps.search.SearchDemo;
import org.starl.geometry.Pose;

/** Each of StarL's apps on a phone starts, and drives from the place of its scenario's first robot. */
@RunWith(RobolectricTestRunner.class)
@Category(TakesLong.class)
@Config(
    sdk = 37,
    shadows = {AdapterShadow.class, SocketShadow.class, BinderShadow.class})
public final class PhoneAppsTest extends ServiceFixture {

  /** Places the car where the app's scenario has its only robot, and starts that app. */
  private void begin(Demo demo, String more) throws Exception {
    SortedMap<String, String> parameters = demo.defaults();
    Request request = new Request(7, OptionalInt.of(1), parameters);
    Plan plan = demo.plan(request, demo.defaultSettings(request).build());
    Pose start = plan.simulation().build().plan().robots().get(0).start();
    car.close();
    car = new SimulatedCar("bot0", start, clock, event -> {});
    load(deployment(demo.name()) + more + "seed: 7\n");
    tell(RobotService.START);
    until(() -> service.phase() != Phase.STARTING);
  }

  private void drives(Demo demo, String more) throws Exception {
    begin(demo, more);
    until(() -> {
      assertThat(service.problem()).isEmpty();
      return car.turnsItsWheels();
    });
    assertThat(service.status().app()).isEqualTo(demo.name());
    assertThat(service.status().appState()).startsWith("runs");
  }

  @Test
  public void theIntersectionDrives() throws Exception {
    drives(new IntersectionDemo(), "parameters: {scenario: figure7, debris: 0}\n");
  }

  @Test
  public void theRaceDrives() throws Exception {
    drives(new RaceDemo(), "");
  }

  @Test
  public void theMazeDrives() throws Exception {
    drives(new MazeDemo(), "");
  }

  @Test
  public void lightpaintDrives() throws Exception {
    drives(new LightPaintDemo(), "");
  }

  @Test
  public void theSearchDrivesWithAnObjectSensorOnly() throws Exception {
    begin(new SearchDemo(), "");
    until(() -> service.phase() == Phase.FAILED);
    assertThat(service.problem()).contains("this robot has no object sensor");
    assertThat(car.turnsItsWheels()).isFalse();
    tell(RobotService.STOP);
    until(() -> service.status() == null);
    drives(new SearchDemo(), "    objects: positions\n");
  }
}
