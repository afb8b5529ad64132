package org.starl.build;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideOutsideOfPackages;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.methods;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaFieldAccess.AccessType;
import com.tngtech.archunit.core.domain.JavaMethod;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.ConditionEvents;
import com.tngtech.archunit.lang.SimpleConditionEvent;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;

/** Which packages may import which, each law with a class that breaks it. */
final class Layers {

  /** A law, and the classes in test scope that stand in its packages and break it. */
  record Law(String name, ArchRule rule, List<Class<?>> brokenBy) {

    Law(String name, ArchRule rule, Class<?>... brokenBy) {
      this(name, rule, List.of(brokenBy));
    }

    @Override
    public String toString() {
      return name;
    }
  }

  /** Core's packages. */
  private static final String[] IN_CORE = {
    "org.starl",
    "org.starl.body..",
    "org.starl.comms..",
    "org.starl.fixture..",
    "org.starl.geometry..",
    "org.starl.gvh..",
    "org.starl.id..",
    "org.starl.motion..",
    "org.starl.platform..",
    "org.starl.random..",
    "org.starl.session..",
    "org.starl.shape..",
    "org.starl.spec..",
    "org.starl.time..",
    "org.starl.trace.."
  };

  private static final String[] DESKTOP = {"java.awt..", "javax.swing..", "javax.imageio.."};
  private static final String LOGIC = "org.starl.apps..logic..";
  private static final String SPEC = "org.starl.apps..spec..";
  private static final String ON_ROBOTS = "org.starl.apps..robot..";

  /** What an app's factory is made of. */
  private static final Pattern FACTORY =
      Pattern.compile("org\\.starl\\.apps\\.(AppFactory|Parameter|Request|RobotProgram)");

  private static final String PRIMITIVES = "org.starl.primitives..";
  private static final String SIM = "org.starl.sim..";
  private static final String LANG = "org.starl.lang..";
  private static final String INPUT = "org.starl.input..";
  private static final String ROBOT = "org.starl.robot..";
  private static final String[] VIEW = {
    "org.starl.sim.view..",
    "org.starl.sim.record..",
    "org.starl.sim.replay..",
    "org.starl.sim.export.."
  };

  private static final DescribedPredicate<JavaClass> CORE = resideInAnyPackage(IN_CORE).as("core");

  private static final DescribedPredicate<JavaClass> ON_A_PHONE =
      resideInAnyPackage(SPEC, ON_ROBOTS)
          .or(
              DescribedPredicate.describe(
                  "factories", type -> FACTORY.matcher(type.getName()).matches()))
          .as("factories, specifications and robots' side of apps");

  /** What a phone has, and nothing that needs a library. */
  private static final DescribedPredicate<JavaClass> PLAIN_JAVA =
      resideInAnyPackage("java..", "javax.crypto..", "org.jspecify..")
          .or(DescribedPredicate.describe("primitive types", type -> type.isPrimitive()))
          .and(resideOutsideOfPackages(DESKTOP))
          .as("the JDK without its desktop");

  private static final ArchCondition<JavaMethod> ONLY_ANSWER =
      new ArchCondition<>("return a boolean and set no field") {
        @Override
        public void check(JavaMethod method, ConditionEvents events) {
          boolean answers =
              Set.of("boolean", "java.lang.Boolean").contains(method.getRawReturnType().getName());
          boolean changes =
              method.getFieldAccesses().stream()
                  .anyMatch(access -> access.getAccessType() == AccessType.SET);
          if (!answers || changes) {
            events.add(SimpleConditionEvent.violated(method, method.getFullName()));
          }
        }
      };

  static final List<Law> LAWS =
      List.of(
          new Law(
              "core imports the JDK alone",
              classes().that(CORE).should().onlyDependOnClassesThat(PLAIN_JAVA.or(CORE)),
              org.starl.fixture.CoreImportsPrimitives.class),
          new Law(
              "primitives import core",
              classes()
                  .that()
                  .resideInAPackage(PRIMITIVES)
                  .should()
                  .onlyDependOnClassesThat(
                      PLAIN_JAVA
                          .or(CORE)
                          .or(resideInAnyPackage(PRIMITIVES, "org.locationtech.jts.."))),
              org.starl.primitives.fixture.PrimitiveImportsSimulator.class),
          new Law(
              "the simulator imports core",
              onlyOf(SIM, CORE.or(resideInAnyPackage(INPUT, SIM))),
              org.starl.sim.fixture.SimulatorImportsPrimitive.class),
          new Law(
              "the simulator runs without its viewer",
              noClasses()
                  .that(resideInAPackage(SIM).and(resideOutsideOfPackages(VIEW)))
                  .should()
                  .dependOnClassesThat()
                  .resideInAnyPackage(VIEW),
              org.starl.sim.fixture.SimulatorImportsViewer.class),
          new Law(
              "the real platform imports core",
              onlyOf(ROBOT, CORE.or(resideInAnyPackage(INPUT, ROBOT))),
              org.starl.robot.fixture.PlatformImportsSimulator.class),
          new Law(
              "the language imports input alone of StarL",
              noClasses()
                  .that()
                  .resideInAPackage(LANG)
                  .should()
                  .dependOnClassesThat(
                      resideInAPackage("org.starl..").and(resideOutsideOfPackages(LANG, INPUT))),
              org.starl.lang.fixture.LanguageImportsCore.class),
          new Law(
              "an app's logic imports core and primitives",
              classes()
                  .that()
                  .resideInAPackage(LOGIC)
                  .should()
                  .onlyDependOnClassesThat(
                      PLAIN_JAVA.or(CORE).or(resideInAnyPackage(PRIMITIVES, LOGIC))),
              org.starl.apps.fixture.logic.LogicImportsSimulator.class),
          new Law(
              "an app on robots runs without the simulator",
              classes()
                  .that(ON_A_PHONE)
                  .should()
                  .onlyDependOnClassesThat(
                      PLAIN_JAVA
                          .or(CORE)
                          .or(resideInAnyPackage(PRIMITIVES, INPUT, LOGIC))
                          .or(ON_A_PHONE)),
              org.starl.apps.fixture.robot.FactoryImportsSimulator.class),
          new Law(
              "an app's logic runs on Android 8",
              noClasses()
                  .that(resideInAPackage(LOGIC).or(ON_A_PHONE))
                  .should()
                  .accessTargetWhere(AndroidGaps.ACCESS),
              org.starl.apps.fixture.logic.LogicUsesNewJava.class),
          new Law(
              "the kernel imports core alone: no robot, radio, world, fault or observer",
              onlyOf("org.starl.sim.kernel..", CORE.or(resideInAPackage("org.starl.sim.kernel.."))),
              org.starl.sim.kernel.fixture.KernelImportsObserver.class),
          new Law(
              "a part of the simulator does not know the facade that joins the parts",
              noClasses()
                  .that()
                  .resideInAnyPackage(
                      "org.starl.sim.net..", "org.starl.sim.world..", "org.starl.sim.fault..")
                  .should()
                  .dependOnClassesThat()
                  .resideInAPackage("org.starl.sim"),
              org.starl.sim.net.fixture.NetImportsFacade.class),
          new Law(
              "the air and the world know no fault by name",
              noClasses()
                  .that()
                  .resideInAnyPackage("org.starl.sim.net..", "org.starl.sim.world..")
                  .should()
                  .dependOnClassesThat()
                  .resideInAPackage("org.starl.sim.fault.."),
              org.starl.sim.net.fixture.NetImportsFault.class),
          new Law(
              "the desktop is drawn on in views alone",
              noClasses()
                  .that()
                  .resideOutsideOfPackages(
                      "org.starl.sim.view..", "org.starl.sim.record..", "org.starl.apps..view..")
                  .should()
                  .dependOnClassesThat()
                  .resideInAnyPackage(DESKTOP),
              org.starl.sim.fixture.SimulatorDraws.class),
          new Law(
              "JUnit is for tests alone",
              noClasses()
                  .that()
                  .resideOutsideOfPackage("org.starl.sim.junit..")
                  .should()
                  .dependOnClassesThat()
                  .resideInAPackage("org.junit.."),
              org.starl.sim.fixture.SimulatorTests.class),
          new Law(
              "no package imports itself through others",
              slices().matching("(org.starl..)").should().beFreeOfCycles(),
              org.starl.fixture.CoreInACycle.class,
              org.starl.sim.fixture.SimulatorInACycle.class),
          new Law(
              "a method called is... answers yes or no and changes nothing",
              methods().that().haveNameMatching("is[A-Z].*").should(ONLY_ANSWER),
              org.starl.fixture.CoreChangesInQuestion.class),
          new Law(
              "no module imports the one for Spark",
              noClasses()
                  .that()
                  .resideOutsideOfPackage("org.starl.spark..")
                  .should()
                  .dependOnClassesThat()
                  .resideInAPackage("org.starl.spark.."),
              org.starl.cli.fixture.CommandLineImportsSpark.class),
          new Law(
              "no module imports the one for ROS 2, which alone imports its library",
              noClasses()
                  .that()
                  .resideOutsideOfPackage("org.starl.ros2..")
                  .should()
                  .dependOnClassesThat()
                  .resideInAnyPackage("org.starl.ros2..", "us.ihmc.."),
              org.starl.cli.fixture.CommandLineImportsRos2.class),
          new Law(
              "no module imports the server",
              noClasses()
                  .that()
                  .resideOutsideOfPackage("org.starl.serve..")
                  .should()
                  .dependOnClassesThat()
                  .resideInAPackage("org.starl.serve.."),
              org.starl.cli.fixture.CommandLineImportsServer.class),
          new Law(
              "Android is the leaf's",
              noClasses()
                  .that()
                  .resideOutsideOfPackage("org.starl.android..")
                  .should()
                  .dependOnClassesThat()
                  .resideInAPackage("android.."),
              org.starl.fixture.CoreImportsAndroid.class));

  private Layers() {}

  /** Of StarL's own packages only these; libraries are the module's business. */
  private static ArchRule onlyOf(String packages, DescribedPredicate<JavaClass> allowed) {
    return classes()
        .that()
        .resideInAPackage(packages)
        .should()
        .onlyDependOnClassesThat(allowed.or(resideOutsideOfPackages("org.starl..")));
  }
}
