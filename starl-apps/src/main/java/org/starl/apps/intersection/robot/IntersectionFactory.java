package org.starl.apps.intersection.robot;

import java.util.ArrayList;
import java.util.List;
import org.starl.apps.AppFactory;
import org.starl.apps.Parameter;
import org.starl.apps.Request;
import org.starl.apps.RobotProgram;
import org.starl.apps.intersection.logic.CrossingFact;
import org.starl.apps.intersection.logic.Trip;
import org.starl.apps.intersection.spec.ListCrit;
import org.starl.input.BadInput;
import org.starl.input.Form;
import org.starl.input.Quantity;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.random.Rng;
import org.starl.trace.Vocabulary;

/** Paper, section 3, with a fixed set of cars: the first robot by name is the first car. */
public final class IntersectionFactory implements AppFactory {

  /** The name of the intersection: cars with another one are at another intersection. */
  public static final String XID = "crossing";

  public static final Parameter SCENARIO =
      new Parameter("scenario", "drawn", "one of the scenarios above");
  public static final Parameter DEBRIS =
      new Parameter(
          "debris",
          "1",
          "pieces of debris on the crossing, from the seed: hidden from all cars, removed"
              + " after 5 to 30 s",
          Form.whole(0, 8));
  public static final Parameter ARRIVALS =
      new Parameter(
          "arrivals",
          "",
          "mean rate of cars that arrive (scenario=open: 20/min); implies scenario=open",
          Form.above0(Quantity.RATE));
  public static final Parameter FILES =
      new Parameter(
          "files", "", "folder of start.wpt, dest.wpt and obstacles.wpt, for scenario=legacy");

  public static final Parameter CAR =
      Parameter.choice(
          "car",
          "the cars' program: flow, which keeps moving; paper, after the paper's Figure 4; or"
              + " program, after Figure 3",
          "flow",
          "paper",
          "program");

  public static final String DRAWN = "drawn";
  public static final String FIGURE7 = "figure7";

  @Override
  public String name() {
    return "intersection";
  }

  @Override
  public Vocabulary vocabulary(Request request) {
    return switch (CarProgram.of(request)) {
      case FLOW, PAPER -> CrossingFact.FIGURE_4;
      case PROGRAM -> CrossingFact.FIGURE_3;
    };
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(SCENARIO, CAR, ARRIVALS, DEBRIS, FILES);
  }

  /** The pieces of debris, which exist on a simulated floor only. */
  public static int debris(Request request) {
    return request.whole(DEBRIS);
  }

  /**
   * The cars of a scenario without files and arrivals, at most one for each robot.
   *
   * @param prefix of their names
   * @param robots their number, where the scenario leaves it open
   */
  public static List<Car> cars(Request request, String prefix, int robots) {
    Rng rng = new Rng(request.seed()).fork("intersection");
    return request.parameter(SCENARIO.key()).equals(FIGURE7)
        ? Car.figure7(prefix)
        : Car.drawn(prefix, robots, rng.fork("cars"));
  }

  @Override
  public RobotProgram program(Request request) {
    String scenario = request.parameter(SCENARIO.key());
    if (!scenario.equals(DRAWN) && !scenario.equals(FIGURE7)) {
      throw new BadInput(
          "scenario=" + BadInput.quote(scenario) + ": expected drawn or figure7 on robots");
    }
    request.refuseOnRobots(ARRIVALS);
    request.refuseOnRobots(FILES);
    debris(request);
    int robots = request.robots().orElse(1);
    List<Trip> trips = new ArrayList<>();
    cars(request, "bot", robots).forEach(car -> trips.add(car.trip()));
    if (robots > trips.size()) {
      throw new BadInput(
          "robots: " + robots + ": expected at most " + trips.size() + " for " + scenario);
    }
    CarProgram car = CarProgram.of(request);
    return RobotProgram.of(
            gvh -> car.of(gvh, trips.get(RobotProgram.number(gvh)), gvh.id.participants()))
        .withMap(Floor.kerbs())
        .withMonitor(() -> new ListCrit(XID))
        .withMonitor(() -> new MutexSpec().only(XID))
        .withMonitor(RegistrationSpec::new);
  }
}
