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
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.platform.engine.discovery.DiscoverySelectors.selectClass
import org.junit.platform.testkit.engine.EngineTestKit
import org.starl.cli.Main

/** A project of `starl new --kotlin` compiles, passes its test, and does as its README says. */
@Tag("long")
class NewProjectTest {

  @TempDir private lateinit var temporary: Path

  private val classes by lazy { temporary.resolve("classes") }

  /** Of its README's tour: as written, with the change, with the planted bug, suspended; compiled together. */
  @Test
  fun itCompilesPassesItsTestAndKeepsTheTour() {
    written(NAME)
    written(CHANGED).apply {
      val (before, after) = blocks()
      edit(app, before, after)
      mendTheTest()
    }
    written(BROKEN).apply {
      val release = blocks()[2].trim()
      edit(app, "            $release\n", "")
      val home = "            gvh.plat.moat.doMove(home)\n"
      edit(app, home, "            $release\n$home")
      mendTheTest()
    }
    written(SUSPENDED).apply {
      edit(app, blocks()[6].trim(), blocks()[5].trim())
      edit(app, "import org.starl.LogicThread", "import org.starl.SuspendedThread")
      edit(app, ": LogicThread(", ": SuspendedThread(")
      mendTheTest()
    }
    compile(NAME, CHANGED, BROKEN, SUSPENDED)
    assertThat(failures("myrobots.MyRobotsTest")).isEmpty()
    assertThat(failures("changed.ChangedTest")).isEmpty()
    assertThat(failures("suspended.SuspendedTest")).isEmpty()
    assertThat(failures("broken.BrokenTest"))
      .hasSize(1)
      .allMatch { it.contains("alone_at_the_dock violated") }
    assertThat(run("run", NAME, "--seed", "7", "--png", "${temporary.resolve("a.png")}"))
      .contains("bot3: visits: 2", "4 of 4 robots", "alone_at_the_dock")
    assertThat(run("campaign", "${temporary.resolve("$NAME/scenario.yaml")}", "--seeds", "1..3"))
      .containsPattern("violated +0\n")
  }

  private inner class Project(private val name: String) {
    private val root = temporary.resolve(name)
    private val type = name.replaceFirstChar { it.uppercase() }
    val app = "src/main/kotlin/$name/${type}App.kt"

    fun blocks(): List<String> =
      Regex("```kotlin\n(.*?)```", RegexOption.DOT_MATCHES_ALL)
        .findAll(root.resolve("README.md").readText())
        .map { it.groupValues[1] }
        .toList()

    fun edit(file: String, old: String, changed: String) {
      val path = root.resolve(file)
      assertThat(path.readText()).containsOnlyOnce(old)
      path.writeText(path.readText().replace(old, changed))
    }

    fun mendTheTest() {
      edit("src/test/kotlin/$name/${type}Test.kt", blocks()[4].trim(), blocks()[3].trim())
    }
  }

  private fun written(name: String): Project {
    val folder = "${temporary.resolve(name)}"
    val (status, said) = starl("new", name, "--kotlin", "--folder", folder)
    assertThat(status).`as`(said).isZero()
    return Project(name)
  }

  private fun compile(vararg names: String) {
    val said = ByteArrayOutputStream()
    val options = listOf("-no-stdlib", "-no-reflect", "-Werror", "-jvm-target", "21")
    val paths = listOf("-cp", System.getProperty("java.class.path"), "-d", "$classes")
    val sources = names.map { "${temporary.resolve("$it/src")}" }
    val status =
      K2JVMCompiler().exec(PrintStream(said), *(options + paths + sources).toTypedArray())
    assertThat(status).`as`(said.toString()).isEqualTo(ExitCode.OK)
    val services = "META-INF/services/org.starl.apps.Demo"
    classes.resolve(services).parent.createDirectories()
    temporary.resolve("$NAME/src/main/resources/$services").copyTo(classes.resolve(services), true)
  }

  /** The messages of the failures of a test class. */
  private fun failures(type: String): List<String> = withClasses { loader ->
    val tests =
      EngineTestKit.engine("junit-jupiter")
        .selectors(selectClass(loader.loadClass(type)))
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
    const val CHANGED = "changed"
    const val BROKEN = "broken"
    const val SUSPENDED = "suspended"
  }
}
