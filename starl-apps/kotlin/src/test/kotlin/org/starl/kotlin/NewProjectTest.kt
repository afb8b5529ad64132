package org.starl.kotlin

import java.io.ByteArrayOutputStream
import java.io.PrintStream
import java.io.PrintWriter
import java.io.StringWriter
import java.net.URLClassLoader
import java.nio.file.Path
import kotlin.io.path.copyTo
import kotlin.io.path.createDirectories
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.assertj.core.api.Assertions.assertThat
import org.jetbrains.kotlin.cli.common.ExitCode
import org.jetbrains.kotlin.cli.jvm.K2JVMCompiler
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.platform.engine.discovery.DiscoverySelectors.selectClass
import org.junit.platform.testkit.engine.EngineTestKit
import org.starl.cli.Main

/** What `starl new --kotlin` writes compiles, passes its test, and keeps what its README says. */
class NewProjectTest {

  @TempDir private lateinit var temporary: Path

  private val root by lazy { temporary.resolve(NAME) }
  private val classes by lazy { temporary.resolve("classes") }

  @Test
  fun itCompilesPassesItsTestAndKeepsTheTour() {
    val (status, said) = starl("new", NAME, "--kotlin", "--folder", "$root")
    assertThat(status).`as`(said).isZero()
    compile()
    assertThat(failures()).isEmpty()
    assertThat(run("run", NAME, "--seed", "7", "--png", "${temporary.resolve("a.png")}"))
      .contains("bot3: visits: 2", "4 of 4 robots", "alone_at_the_dock")
    assertThat(run("campaign", "${root.resolve("scenario.yaml")}", "--seeds", "1..3"))
      .contains("violated                         0")
    plantTheBugOfTheTour()
    compile()
    assertThat(failures()).hasSize(1).allMatch { it.contains("alone_at_the_dock violated") }
  }

  @Test
  fun theChangeOfTheTourIsRight() {
    starl("new", NAME, "--kotlin", "--folder", "$root")
    val (before, after) = blocks()
    edit(APP, before, after)
    mendTheTest()
    compile()
    assertThat(failures()).isEmpty()
  }

  private fun plantTheBugOfTheTour() {
    val release = blocks()[2].trim()
    edit(APP, "            $release\n", "")
    val home = "            gvh.plat.moat.doMove(home)\n"
    edit(APP, home, "            $release\n$home")
    mendTheTest()
  }

  private fun mendTheTest() {
    edit(TEST, blocks()[4].trim(), blocks()[3].trim())
  }

  private fun blocks(): List<String> =
    Regex("```kotlin\n(.*?)```", RegexOption.DOT_MATCHES_ALL)
      .findAll(root.resolve("README.md").readText())
      .map { it.groupValues[1] }
      .toList()

  private fun edit(file: String, old: String, changed: String) {
    val path = root.resolve(file)
    assertThat(path.readText()).containsOnlyOnce(old)
    path.writeText(path.readText().replace(old, changed))
  }

  private fun compile() {
    val said = ByteArrayOutputStream()
    val status =
      K2JVMCompiler()
        .exec(
          PrintStream(said),
          "-no-stdlib",
          "-no-reflect",
          "-Werror",
          "-jvm-target",
          "21",
          "-cp",
          System.getProperty("java.class.path"),
          "-d",
          "$classes",
          "${root.resolve("src")}",
        )
    assertThat(status).`as`(said.toString()).isEqualTo(ExitCode.OK)
    val services = "META-INF/services/org.starl.apps.Demo"
    classes.resolve(services).parent.createDirectories()
    root.resolve("src/main/resources/$services").copyTo(classes.resolve(services), true)
  }

  /** What the failures of its test say. */
  private fun failures(): List<String> =
    withClasses { loader ->
      val tests =
        EngineTestKit.engine("junit-jupiter")
          .selectors(selectClass(loader.loadClass("myrobots.MyRobotsTest")))
          .execute()
          .testEvents()
      assertThat(tests.started().count()).isPositive()
      tests.failed().list().map { it.payload.orElseThrow().toString() }
    }

  private fun run(vararg words: String): String = withClasses {
    val (status, said) = starl(*words)
    assertThat(status).`as`(said).isZero()
    said
  }

  private fun starl(vararg words: String): Pair<Int, String> {
    val said = StringWriter()
    val status = Main.run(PrintWriter(said), PrintWriter(said), *words)
    return Pair(status, said.toString())
  }

  private fun <T> withClasses(action: (ClassLoader) -> T): T {
    val thread = Thread.currentThread()
    val before = thread.contextClassLoader
    return URLClassLoader(arrayOf(classes.toUri().toURL()), javaClass.classLoader).use { loader ->
      thread.contextClassLoader = loader
      try {
        action(loader)
      } finally {
        thread.contextClassLoader = before
      }
    }
  }

  private companion object {
    const val NAME = "my-robots"
    const val APP = "src/main/kotlin/myrobots/MyRobotsApp.kt"
    const val TEST = "src/test/kotlin/myrobots/MyRobotsTest.kt"
  }
}
