// The build that users of StarL expect. Beside it stands a Maven build (pom.xml) for networks that
// cannot fetch a Gradle distribution; the quality gates are there. A test compares the two.
pluginManagement {
    repositories {
        mavenCentral()
        gradlePluginPortal()
    }
}

rootProject.name = "starl"

dependencyResolutionManagement {
    repositories {
        mavenCentral()
    }
}

// The modules of pom.xml: starl-sim/view is :starl-sim-view. Those of Spark, ROS 2, the server and JMH are there with
// -Pspark, -Pros2, -Pserve, -Pjmh alone.
Regex("<module>(.+)</module>").findAll(rootDir.resolve("pom.xml").readText()).map { it.groupValues[1] }.filter {
    it !in listOf("starl-cli/spark", "starl-android/ros2", "starl-cli/serve", "starl-cli/jmh") ||
        providers.gradleProperty(it.substringAfterLast('/')).isPresent
}.forEach { folder ->
    val name = ":" + folder.replace('/', '-')
    include(name)
    project(name).projectDir = rootDir.resolve(folder)
}
