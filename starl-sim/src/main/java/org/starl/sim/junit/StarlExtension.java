package org.starl.sim.junit;

import java.lang.System.Logger.Level;
import java.lang.reflect.Method;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.junit.jupiter.api.extension.ExtensionConfigurationException;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.InvocationInterceptor;
import org.junit.jupiter.api.extension.ParameterContext;
import org.junit.jupiter.api.extension.ParameterResolver;
import org.junit.jupiter.api.extension.ReflectiveInvocationContext;
import org.junit.platform.commons.support.AnnotationSupport;
import org.junit.platform.commons.support.ReflectionSupport;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.sim.SimResult;
import org.starl.sim.Simulation;
import org.starl.sim.fault.FaultPlan;
import org.starl.sim.kernel.CarrierKind;

/**
 * Runs the methods marked {@link StarlTest}. JUnit resolves a method's parameters once; its one
 * invocation is replaced by one invocation per seed, with that seed's builder.
 */
final class StarlExtension implements ParameterResolver, InvocationInterceptor {

  /** The configuration parameter or system property that selects a single seed. */
  static final String SEED = "starl.seed";

  /** The same for a cell of the matrix, as it is printed. */
  static final String CELL = "starl.cell";

  StarlExtension() {}

  @Override
  public boolean supportsParameter(ParameterContext parameter, ExtensionContext context) {
    Class<?> type = parameter.getParameter().getType();
    boolean isOfTest =
        context
            .getTestMethod()
            .filter(method -> method.equals(parameter.getDeclaringExecutable()))
            .isPresent();
    return isOfTest
        && (type == Simulation.Builder.class
            || type == RunChecks.class
            || type == Cell.class
            || type == long.class);
  }

  @Override
  public Object resolveParameter(ParameterContext parameter, ExtensionContext context) {
    Class<?> type = parameter.getParameter().getType();
    if (type == long.class) {
      return 0L;
    }
    if (type == Cell.class) {
      return Cell.NONE;
    }
    RunChecks ignored = assertion -> {};
    return type == RunChecks.class ? ignored : Simulation.builder();
  }

  @Override
  public void interceptTestMethod(
      Invocation<Void> invocation,
      ReflectiveInvocationContext<Method> test,
      ExtensionContext context)
      throws InterruptedException {
    invocation.skip();
    sayWhyRunsAreSlow(context);
    Method method = test.getExecutable();
    StarlTest annotation = AnnotationSupport.findAnnotation(method, StarlTest.class).orElseThrow();
    Optional<Long> alone = context.getConfigurationParameter(SEED).flatMap(StarlExtension::seed);
    if (annotation.seeds() < 1) {
      throw new ExtensionConfigurationException(
          "seeds = " + annotation.seeds() + ": expected at least 1");
    }
    long first = alone.orElse(annotation.firstSeed());
    long last = alone.orElse(annotation.firstSeed() + annotation.seeds() - 1);
    String name = context.getRequiredTestClass().getName() + "#" + method.getName();
    RunFiles files = files(context);
    files.removeOld(name);
    for (Cell cell : cells(annotation, context)) {
      new SeededRuns(
              name,
              cell,
              faults(annotation),
              annotation.chaos(),
              atMostNs(annotation),
              schedules(annotation),
              files,
              (seed, simulation, afterwards) ->
                  ReflectionSupport.invokeMethod(
                      method,
                      test.getTarget().orElse(null),
                      arguments(test, cell, seed, simulation, afterwards)))
          .run(first, last);
    }
  }

  /** The cells of the matrix, or the one that was asked for. */
  private static List<Cell> cells(StarlTest annotation, ExtensionContext context) {
    try {
      List<Cell> all = Cell.of(annotation.matrix());
      String asked = context.getConfigurationParameter(CELL).map(String::strip).orElse("");
      if (asked.isEmpty() || annotation.matrix().length == 0) {
        return all;
      }
      List<Cell> cells = all.stream().filter(cell -> cell.toString().equals(asked)).toList();
      if (cells.isEmpty()) {
        throw new ExtensionConfigurationException(
            CELL + "=" + BadInput.quote(asked) + ": expected one of " + all);
      }
      return cells;
    } catch (BadInput wrong) {
      throw new ExtensionConfigurationException(String.valueOf(wrong.getMessage()), wrong);
    }
  }

  /** Logs, once for all tests, that robots run on platform threads, and how to change that. */
  private static void sayWhyRunsAreSlow(ExtensionContext context) {
    String reason = CarrierKind.fallbackReason();
    if (reason != null) {
      context
          .getRoot()
          .getStore(ExtensionContext.Namespace.create(StarlExtension.class))
          .getOrComputeIfAbsent(
              CarrierKind.class,
              once -> {
                System.getLogger(StarlTest.class.getName()).log(Level.INFO, reason);
                return reason;
              });
    }
  }

  private static RunFiles files(ExtensionContext context) {
    return new RunFiles(
        context
            .getConfigurationParameter(RunFiles.FOLDER)
            .filter(folder -> !folder.isBlank())
            .map(Path::of)
            .orElseGet(RunFiles::usualFolder),
        context.getConfigurationParameter(RunFiles.VIEW).filter("true"::equals).isPresent());
  }

  private static Object[] arguments(
      ReflectiveInvocationContext<Method> test,
      Cell cell,
      long seed,
      Simulation.Builder simulation,
      List<Consumer<SimResult>> checks) {
    Class<?>[] types = test.getExecutable().getParameterTypes();
    List<Object> arguments = new ArrayList<>(test.getArguments());
    RunChecks afterwards = checks::add;
    for (int i = 0; i < types.length; i++) {
      if (types[i] == Simulation.Builder.class) {
        arguments.set(i, simulation);
      } else if (types[i] == RunChecks.class) {
        arguments.set(i, afterwards);
      } else if (types[i] == Cell.class) {
        arguments.set(i, cell);
      } else if (types[i] == long.class) {
        arguments.set(i, seed);
      }
    }
    return arguments.toArray();
  }

  private static FaultPlan faults(StarlTest annotation) {
    FaultPlan faults = FaultPlan.NONE;
    for (String fault : annotation.faults()) {
      try {
        faults = faults.plus(FaultPlan.parse(fault));
      } catch (BadInput wrong) {
        throw new ExtensionConfigurationException("faults: " + wrong.getMessage(), wrong);
      }
    }
    return faults;
  }

  private static int schedules(StarlTest annotation) {
    if (annotation.explore() < 0) {
      throw new ExtensionConfigurationException(
          "explore = " + annotation.explore() + ": expected at least 0");
    }
    return annotation.explore();
  }

  private static long atMostNs(StarlTest annotation) {
    try {
      return Quantities.durationNs(annotation.atMost());
    } catch (BadInput wrong) {
      throw new ExtensionConfigurationException("atMost = " + wrong.getMessage(), wrong);
    }
  }

  /** Empty if the parameter is blank, because builds pass it even if it is not set. */
  private static Optional<Long> seed(String text) {
    if (text.isBlank()) {
      return Optional.empty();
    }
    try {
      return Optional.of(Long.valueOf(text.strip()));
    } catch (NumberFormatException wrong) {
      throw new ExtensionConfigurationException(
          SEED + "=" + BadInput.quote(text) + ": expected a seed, a whole number", wrong);
    }
  }
}
