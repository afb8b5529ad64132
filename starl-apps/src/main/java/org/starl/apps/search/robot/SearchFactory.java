package org.starl.apps.search.robot;

import java.util.List;
import java.util.function.Function;
import org.starl.GlobalVarHolder;
import org.starl.apps.AppFactory;
import org.starl.apps.Parameter;
import org.starl.apps.Request;
import org.starl.apps.RobotProgram;
import org.starl.apps.search.logic.Drive;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.logic.HousePlan;
import org.starl.apps.search.logic.SearchApp;
import org.starl.apps.search.logic.SearchFact;
import org.starl.body.MotionParameters;
import org.starl.input.BadInput;
import org.starl.input.Form;
import org.starl.primitives.agreement.AgreementSpec;
import org.starl.primitives.election.ElectionSpec;
import org.starl.random.Rng;
import org.starl.trace.Vocabulary;

/**
 * The paper's search, of a house drawn from the seed. A robot needs an object sensor; where the thing
 * is, only the scenario knows.
 */
public final class SearchFactory implements AppFactory {

  public static final String GENERATED = "generated";
  public static final String NONE = "none";
  public static final String DRAWN = "drawn";

  public static final Parameter SCENARIO =
      new Parameter("scenario", GENERATED, "one of the scenarios above");
  public static final Parameter ROOMS =
      new Parameter(
          "rooms",
          "6",
          "number of rooms of a generated house",
          Form.whole(1, GeneratedHouse.MAX_ROOMS));
  public static final Parameter OBJECT =
      new Parameter(
          "object",
          DRAWN,
          "the thing to find: drawn (the files' things; in a generated house, at a place from the"
              + " seed), none, or x,y in mm");
  public static final Parameter FILES =
      new Parameter(
          "files",
          "",
          "folder of obstacles.wpt (walls), dest.wpt (doors), start.wpt (robots) and"
              + " senseObjects.wpt (things to find)");

  /** As far as the original's sensor. */
  public static final double RANGE_MM = 600;

  private static final String XID = "house";
  private static final int MAX_ROBOTS = 1000;

  @Override
  public String name() {
    return "search";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(SCENARIO, ROOMS, OBJECT, FILES);
  }

  @Override
  public Vocabulary vocabulary(Request request) {
    return SearchFact.VOCABULARY;
  }

  @Override
  public RobotProgram program(Request request) {
    request.refuseOnRobots(SCENARIO);
    request.refuseOnRobots(FILES);
    House house = house(request, request.robots().orElse(1), request.motion());
    return RobotProgram.of(app(house))
        .withMap(house.plan().walls())
        .withMonitor(AgreementSpec::new)
        .withMonitor(ElectionSpec::new);
  }

  /** The app of a robot. */
  public static Function<GlobalVarHolder, SearchApp> app(House house) {
    return gvh -> new SearchApp(gvh, XID, house);
  }

  /**
   * The house that a request draws.
   *
   * @throws BadInput if a search has not so many robots, or a house not so many rooms
   */
  public static House house(Request request, int robots, MotionParameters body) {
    if (robots < 1 || robots > MAX_ROBOTS) {
      throw new BadInput("robots: " + robots + ": expected 1 to " + MAX_ROBOTS);
    }
    HousePlan plan = GeneratedHouse.of(request.whole(ROOMS), robots, rng(request).fork("house"));
    return House.of(plan, RANGE_MM, Drive.clearanceMm(body, plan.bounds()));
  }

  /** The generator of a request's house and object. */
  public static Rng rng(Request request) {
    return new Rng(request.seed()).fork("search");
  }
}
