package org.starl.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.lang.invoke.MethodType;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.sim.net.Latency;

final class SimSettingsTest {

  @Test
  void defaultsAreThoseOfTheOriginalStarL() {
    SimSettings settings = SimSettings.defaults();
    assertThat(settings.robots()).isEqualTo(4);
    assertThat(settings.robotRadiusMm()).isEqualTo(165);
    assertThat(settings.positionPeriodNs()).isEqualTo(75_000_000);
    assertThat(settings.messageDelay()).hasToString("uniform(10ms,20ms)");
    assertThat(settings.messageLoss().probability()).isZero();
    assertThat(settings.get(Setting.FLOOR_WIDTH)).isEqualTo(5000);
  }

  @Test
  void aRunEndsAfterTwentyMinutesUnlessItsDurationIsZero() {
    assertThat(SimSettings.defaults().endNs()).isEqualTo(1_200_000_000_000L);
    assertThat(SimSettings.builder().set("duration", "0ms").build().endNs())
        .isEqualTo(Long.MAX_VALUE);
  }

  @Test
  void aWrittenSettingIsReadBack() {
    SimSettings settings =
        SimSettings.builder()
            .set("messageDelay", "normal(100ms,20ms)")
            .set("messageLoss", "0.25")
            .set("positionNoise", "2cm")
            .set("headingNoise", "3deg")
            .set("maxSpeed", "0.3m/s")
            .set("duration", "90s")
            .set("obstacleFile", "maze/obstacles.wpt")
            .set("idealMotion", "true")
            .build();
    SimSettings.Builder copy = SimSettings.builder();
    settings.asText().forEach(copy::set);
    assertThat(copy.build()).isEqualTo(settings);
    assertThat(settings.asText())
        .containsEntry("messageDelay", "normal(100ms,20ms)")
        .containsEntry("positionNoise", "20mm")
        .containsEntry("maxSpeed", "300mm/s")
        .containsEntry("duration", "90s");
  }

  /** What {@code --set key=value} can say, a typed method of the builder can say, and nothing else. */
  @Test
  void theBuilderHasAMethodForEachKey() throws ReflectiveOperationException {
    Set<String> keys = new TreeSet<>();
    Set<String> methods = new TreeSet<>();
    for (Method method : SimSettings.Builder.class.getDeclaredMethods()) {
      if (Modifier.isPublic(method.getModifiers()) && method.getParameterCount() == 1) {
        methods.add(method.getName());
      }
    }
    for (Setting<?> setting : Setting.all()) {
      keys.add(setting.key());
      SimSettings.Builder builder = SimSettings.builder();
      Class<?> type =
          MethodType.methodType(setting.defaultValue().getClass()).unwrap().returnType();
      Method typed = methodOf(setting.key(), type);
      typed.invoke(builder, setting.defaultValue());
      assertThat(builder.build().given().keySet()).as(setting.key()).isEqualTo(Set.of(setting));
    }
    assertThat(methods).isEqualTo(keys);
  }

  private static Method methodOf(String key, Class<?> value) {
    for (Method method : SimSettings.Builder.class.getDeclaredMethods()) {
      if (method.getName().equals(key) && method.getParameterTypes()[0].isAssignableFrom(value)) {
        return method;
      }
    }
    throw new AssertionError("no method " + key + "(" + value.getSimpleName() + ")");
  }

  @Test
  void keysAreUniqueAndHaveDescriptions() {
    Set<String> keys = new HashSet<>();
    for (Setting<?> setting : Setting.all()) {
      assertThat(keys.add(setting.key())).as(setting.key()).isTrue();
      assertThat(setting.meaning()).isNotBlank();
      SimSettings.builder().set(setting.key(), setting.defaultText());
    }
    SimSettings withAll =
        SimSettings.builder()
            .reaction(Duration.ZERO)
            .radioRange(0)
            .radioSight(false)
            .redraws(Redraws.NONE)
            .build();
    assertThat(withAll.asText().keySet()).isEqualTo(keys);
    Setting.HEADER_IF_GIVEN.forEach(setting -> keys.remove(setting.key()));
    assertThat(SimSettings.defaults().asText().keySet())
        .as("traces without them are as before")
        .isEqualTo(keys);
  }

  @Test
  void theErrorForAMistypedKeySuggestsSimilarKeys() {
    assertThatThrownBy(() -> SimSettings.builder().set("mesageLoss", "0"))
        .isInstanceOf(BadInput.class)
        .hasMessage("no setting is called 'mesageLoss'; did you mean messageLoss?");
    assertThatThrownBy(() -> SimSettings.builder().set("robot", "0"))
        .hasMessageContaining("did you mean robots");
    assertThatThrownBy(() -> SimSettings.builder().set("xyzzy", "0"))
        .hasMessageContaining("expected one of robots, ");
  }

  @Test
  void theErrorForABadValueNamesKeyValueAndExpectation() {
    assertBad("robots", "many", "robots='many': expected a whole number of at least 0");
    assertBad("robots", "-1", "robots='-1': expected a whole number of at least 0");
    assertBad("positionPeriod", "0ms", "positionPeriod=0ms: expected a duration of at least 1ms");
    assertBad("robotRadius", "0", "robotRadius=0mm: expected a distance above 0");
    assertBad("idealMotion", "maybe", "idealMotion='maybe': expected true or false");
    assertBad("robotName", "7up", "robotName=7up: expected a letter, then up to 23 of");
    assertBad("messageDelay", "banana(1)", "messageDelay='banana(1)': expected a delay, 100ms");
    assertBad("duration", "60", "duration='60': expected a duration with a unit");
  }

  private static void assertBad(String key, String value, String message) {
    assertThatThrownBy(() -> SimSettings.builder().set(key, value))
        .isInstanceOf(BadInput.class)
        .hasMessageStartingWith(message)
        .hasMessageNotContaining("\n");
  }

  @Test
  void typedValuesAreValidated() {
    assertThatThrownBy(() -> SimSettings.builder().messageLoss(1.5))
        .isInstanceOf(BadInput.class)
        .hasMessage("messageLoss=1.5: expected a number from 0 to 1");
    assertThatThrownBy(() -> SimSettings.builder().duration(Duration.ofSeconds(-1)))
        .isInstanceOf(BadInput.class);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "robots=3 discoveryRobots=2 randomRobots=2 | discoveryRobots=2 and randomRobots=2:"
            + " expected no more than robots=3 together",
        "randomRobots=1 idealMotion=true | discoveryRobots=0 and randomRobots=1: expected none with"
            + " idealMotion=true, in which bodies do not bump",
        "speedError=0.1 idealMotion=true | speedError=0.1: expected 0 with idealMotion=true, in"
            + " which wheels are exact",
        "maxSpeed=20mm/s | maxSpeed=20mm/s: expected at least 25mm/s: a slower motion fails",
        "positionNoise=501mm | positionNoise=501mm: expected at most 500mm: with a larger error no"
            + " robot moves",
        "startSpacing=1.9 | startSpacing=1.9: expected at least 2 (robotRadius): bodies would"
            + " overlap",
        "floorHeight=300mm | floorHeight=300mm: expected at least 330mm, twice robotRadius",
        "duration=10s faults=crash(bot1,at=10s..20s) | 'crash(bot1,at=10s..20s)': begins at 10s at"
            + " the earliest: expected before the end, duration=10s",
        "duration=10s chaos=logical chaosFor=11s | chaosFor=11s: expected no more than"
            + " duration=10s: faults must end within the run"
      })
  void contradictionsAreRefusedBeforeTheRun(String settingsAndMessage) {
    String[] parts = settingsAndMessage.split(" \\| ", -1);
    SimSettings.Builder settings = SimSettings.builder();
    for (String setting : parts[0].split(" ", -1)) {
      int equals = setting.indexOf('=');
      settings.set(setting.substring(0, equals), setting.substring(equals + 1));
    }
    SimSettings all = settings.build();
    Simulation.Builder simulation =
        Simulation.builder().settings(all).robots(all.robots(), Idle::new);
    assertThatThrownBy(simulation::build).isInstanceOf(BadInput.class).hasMessage(parts[1]);
  }

  @Test
  void valuesAtTheLimitDoNotContradict() {
    SimSettings settings =
        SimSettings.builder()
            .set("duration", "10s")
            .set("faults", "crash(bot1,at=9999ms)")
            .set("maxSpeed", "25mm/s")
            .set("positionNoise", "500mm")
            .set("discoveryRobots", "2")
            .set("randomRobots", "2")
            .build();
    assertThat(Simulation.builder().settings(settings).robots(4, Idle::new).build()).isNotNull();
  }

  @Test
  void aFileOfStartsIsRefusedIfTheAppGivesThem() {
    SimSettings settings = SimSettings.builder().set("startFile", "starts.wpt").build();
    Simulation.Builder simulation = Simulation.builder().settings(settings).robot(at(0, 0));
    assertThatThrownBy(simulation::build)
        .isInstanceOf(BadInput.class)
        .hasMessage(
            "startFile=starts.wpt: expected none: this app gives its robots' starts itself");
  }

  @Test
  void bodiesThatWouldOverlapAreRefusedWithBothDistances() {
    Simulation.Builder near = Simulation.builder().robot(at(0, 0)).robot(at(1, 300));
    assertThatThrownBy(near::build)
        .isInstanceOf(BadInput.class)
        .hasMessage(
            "bot0 and bot1 start 300 mm apart: expected at least 330 mm, twice robotRadius");
    Obstacles wall = Obstacles.of(Obstacle.wall(new Point(100, -500), new Point(100, 500)));
    Simulation.Builder inside = Simulation.builder().obstacles(wall).robot(at(0, 0));
    assertThatThrownBy(inside::build)
        .isInstanceOf(BadInput.class)
        .hasMessage("bot0 starts 100 mm from an obstacle: expected at least 165 mm, robotRadius");
  }

  private static RobotSpec at(int i, double xMm) {
    return new RobotSpec(new RobotId("bot" + i), new Pose(xMm, 0, 0), true, Idle::new);
  }

  private static final class Idle extends LogicThread {
    Idle(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      return List.of();
    }
  }

  @Test
  void allContainsEverySettingOfTheSimulator() throws IllegalAccessException {
    List<Object> constants = new ArrayList<>();
    for (Field field : Setting.class.getFields()) {
      if (field.getType() == Setting.class) {
        constants.add(field.get(null));
      }
    }
    assertThat(constants).hasSizeGreaterThan(20).isEqualTo(Setting.all());
  }

  @Test
  void setValuesOverrideTheDefaultsOfAnApp() {
    SimSettings given = SimSettings.builder().set("messageLoss", "0.3").robots(4).build();
    SimSettings ofApp = SimSettings.builder().robots(9).set("floorWidth", "9m").build();
    assertThat(given.has(Setting.ROBOTS)).isTrue();
    assertThat(given.has(Setting.FLOOR_WIDTH)).isFalse();
    assertThat(given.given().values()).containsExactly("0.3", "4");
    assertThat(given.over(ofApp)).isEqualTo(ofApp.toBuilder().robots(4).messageLoss(0.3).build());
    assertThat(given.only(setting -> setting != Setting.ROBOTS).robots()).isEqualTo(4);
    assertThat(given.only(setting -> setting != Setting.ROBOTS).has(Setting.ROBOTS)).isFalse();
  }

  @Test
  void settingsOfAViewerAreKeptAsText() {
    Setting<Integer> width = Setting.whole("width", 128, 1, "of a window");
    SimSettings settings = SimSettings.builder().read(width, "7").build();
    assertThat(settings.get(width)).isEqualTo(7);
    assertThat(settings.asText()).containsEntry("width", "7");
    assertThat(SimSettings.defaults().asText()).doesNotContainKey("width");
  }

  @Test
  void anyAngleIsReadBack() {
    SimSettings settings = SimSettings.builder().set("headingNoise", "0.1deg").build();
    SimSettings.Builder copy = SimSettings.builder();
    settings.asText().forEach(copy::set);
    assertThat(copy.build()).isEqualTo(settings);
  }

  @Test
  void aBuilderCopiesOtherSettings() {
    SimSettings settings = SimSettings.builder().robots(9).build();
    SimSettings changed =
        settings.toBuilder().messageDelay(new Latency.Constant(1_000_000)).build();
    assertThat(changed.robots()).isEqualTo(9);
    assertThat(changed).isNotEqualTo(settings);
    assertThat(settings.messageDelay()).hasToString("uniform(10ms,20ms)");
    Map<String, String> text = changed.asText();
    assertThat(text).containsEntry("messageDelay", "1ms");
  }
}
