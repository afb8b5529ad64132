// Kotlin needs a plugin that is not Gradle's own, so this is a build of its own, over StarL's:
// ./gradlew -p starl-apps/kotlin check
pluginManagement {
    repositories {
        mavenCentral()
        gradlePluginPortal()
    }
}

rootProject.name = "starl-kotlin"

dependencyResolutionManagement {
    repositories {
        mavenCentral()
    }
    versionCatalogs {
        create("libs") {
            from(files("../../gradle/libs.versions.toml"))
        }
    }
}

// StarL's modules are taken from there, and not from a repository.
includeBuild("../..")
