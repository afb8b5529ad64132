package org.starl.sim.view;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Point;
import org.starl.sim.record.Part;
import org.starl.sim.replay.Recording;

class ViewStateTest {

  private final Session session = new Session(Runs.seconds(3), null);
  private final ViewState view = session.view();

  private void arrange() {
    view.arrange(session.scene(), session.playback().layer(), 800, 600);
  }

  ViewStateTest() {
    session.playback().seek(Runs.SECOND_NS);
    arrange();
  }

  @Test
  void theWholeFloorIsVisibleAtFirst() {
    assertThat(view.viewport().shows(new Point(0, 0), 0)).isTrue();
    assertThat(view.viewport().shows(new Point(1000, 0), 0)).isTrue();
    assertThat(view.viewport().centre().xMm()).isCloseTo(500, within(1e-9));
  }

  @Test
  void zoomingKeepsThePointUnderTheMouse() {
    Point before = view.viewport().toWorld(120, 80);
    view.zoom(3, 120, 80);
    arrange();
    Point after = view.viewport().toWorld(120, 80);
    assertThat(after.distanceMm(before)).isLessThan(1e-6);
    view.fit();
    arrange();
    assertThat(view.viewport().centre().xMm()).isCloseTo(500, within(1e-9));
  }

  @Test
  void panningMovesTheFloorWithTheMouse() {
    Point before = view.viewport().toWorld(100, 100);
    view.pan(30, -20);
    arrange();
    assertThat(view.viewport().toWorld(130, 80).distanceMm(before)).isLessThan(1e-6);
  }

  @Test
  void robotAtFindsTheBodyUnderTheMouse() {
    double x = view.viewport().xPx(new Point(1000, 0));
    double y = view.viewport().yPx(new Point(1000, 0));
    assertThat(view.robotAt(session.scene(), x, y)).isEqualTo(Runs.B);
    assertThat(view.robotAt(session.scene(), x, y + 200)).isNull();
  }

  @Test
  void selectingNeighboursWrapsAround() {
    view.selectNeighbour(session.scene(), true);
    assertThat(view.selected()).isEqualTo(Runs.A);
    view.selectNeighbour(session.scene(), true);
    view.selectNeighbour(session.scene(), true);
    assertThat(view.selected()).isEqualTo(Runs.A);
    view.selectNeighbour(session.scene(), false);
    assertThat(view.selected()).isEqualTo(Runs.B);
  }

  @Test
  void aFollowedRobotStaysInTheCentre() {
    view.select(Runs.B);
    view.follow(true);
    arrange();
    assertThat(view.viewport().centre()).isEqualTo(new Point(1000, 0));
    view.select(null);
    assertThat(view.isFollowing()).isFalse();
  }

  @Test
  void aRunStartsInRealTime() {
    assertThat(ViewSettings.of(Runs.plain().over(0).header()).speed()).isEqualTo(1);
  }

  @Test
  void settingsSetTheLookAndTheSpeed() {
    Recording recording =
        new Runs(
                Map.of(
                    "speed", "0",
                    "drawTrails", "true",
                    "drawObstacles", "false",
                    "drawWaypoints", "false",
                    "maxFps", "12",
                    "faults", "range(3m); crash(bot0,at=1s)"))
            .over(0);
    ViewSettings settings = ViewSettings.of(recording.header());
    assertThat(settings.speed()).isEqualTo(Playback.NO_LIMIT);
    assertThat(settings.maxFps()).isEqualTo(12);
    assertThat(settings.look().shows(Part.TRAILS)).isTrue();
    assertThat(settings.look().shows(Part.WALLS)).isFalse();
    assertThat(settings.look().shows(Part.HIDDEN)).isFalse();
    assertThat(settings.look().shows(Part.APP)).isFalse();
    assertThat(settings.look().rangeMm()).isEqualTo(3000);
    assertThat(session.settings().look().shows(Part.TRAILS)).isFalse();
    assertThat(session.settings().look().rangeMm()).isZero();
  }
}
